#pragma once

#include "app/editing/angiogram_parts.h"
#include "app/editing/treated_run_cache.h"
#include "ui/views/tools/mask_shift_tool.h"
#include "ui/words/retranslation.h"

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <memory>
#include <optional>

namespace angiopose::app {

/// Manages subtraction, the peak-opacification image and the interpretation of the pixel values. A worker computes the
/// new run, which then enters the case as one undo step. During a manual pixel shift, the shown frame is updated
/// immediately and the run when the mouse stops.
class SubtractionController : public QObject {
    Q_OBJECT
public:
    explicit SubtractionController(const AngiogramParts& parts, QObject* parent = nullptr);
    ~SubtractionController() override;   ///< cancels a computation at its next frame and discards the result

    /// Requests the run with these processing settings; a newer request replaces a pending one.
    void change(const core::RunProcessing& wanted, const ui::LocalizedText& undoText);
    bool isComputing() const { return request_.has_value(); }
    bool isFindingShift() const
    {
        return !isShiftFound_;
    }   ///< true while the automatic shift is computed at which a manual pixel shift starts

private:
    using SharedRun = TreatedRunCache::SharedRun;
    using Outcome = core::Result<SharedRun>;
    using PreviewFrame = core::Result<std::shared_ptr<const core::SubtractedFrame>>;
    struct Request {
        SharedRun stored;
        core::RunProcessing processing;
        ui::LocalizedText undoText;
    };

    void connectCommands();
    void connectShift();
    void connectMasks();
    void markMasks(const std::vector<int>& frames);
    void compute();
    void publish();
    void applyRun(const Request& request, const SharedRun& run);
    void beginShift();
    void previewShift(const std::optional<Eigen::Vector2d>& shiftPx);
    void startPreview();
    void showPreview();
    void applyShift();
    void updateFromDocument();
    void showState();

    CaseDocument& document_;
    ViewSync& sync_;
    ui::WindowActions& actions_;
    ui::AngiogramPanel& panel_;
    ui::AngiogramView& view_;
    ui::BottomStrip& strip_;
    Notifications& notifications_;
    ui::MaskShiftTool* shiftTool_;
    std::optional<Request> request_;   ///< newest request that has not been answered yet
    std::optional<Request> computing_;
    std::shared_ptr<std::atomic<bool>> stop_;
    QFutureWatcher<Outcome> run_;
    TreatedRunCache treatedRuns_;
    QFutureWatcher<PreviewFrame> preview_;
    std::optional<core::SubtractionPlan> pendingPreview_;
    bool isShiftFound_ = true;   ///< false while the automatic shift of the frame is computed
    Eigen::Vector2d initialShift_ = Eigen::Vector2d::Zero();   ///< shift of the case, or the automatic one
    QTimer idleTimer_;
    bool isPreviewRangeChanged_ = false;   ///< true if the gray range of the preview differs from that on screen
};

}   // namespace angiopose::app
