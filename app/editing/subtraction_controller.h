#pragma once

#include "app/editing/angiogram_parts.h"
#include "app/editing/treated_runs.h"
#include "ui/views/tools/mask_shift_tool.h"
#include "ui/words/spoken.h"

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <memory>
#include <optional>

namespace angiopose::app {

/// Subtraction, composite and meaning of the pixel values: the run is made on a worker, and taken as one step of undo
/// when it is there. While the mask is moved by hand the frame on screen follows at once, the run when the hand rests.
class SubtractionController : public QObject {
    Q_OBJECT
public:
    explicit SubtractionController(const AngiogramParts& parts, QObject* parent = nullptr);
    ~SubtractionController() override;   ///< what is being made stops at its next frame, and is dropped

    /// Asks for the run so treated; only the newest wish is answered.
    void change(const core::RunTreatment& wanted, const ui::Words& what);
    bool isComputing() const { return request_.has_value(); }
    bool isFindingShift() const { return !isShiftFound_; }   ///< that moving by hand begins with

private:
    using SharedRun = TreatedRuns::SharedRun;
    using Outcome = core::Result<SharedRun>;
    using Picture = core::Result<std::shared_ptr<const core::SubtractedFrame>>;
    struct Request {
        SharedRun stored;
        core::RunTreatment treatment;
        ui::Words what;
    };

    void connectCommands();
    void connectShift();
    void connectMasks();
    void markMasks(const std::vector<int>& frames);
    void compute();
    void publish();
    void take(const Request& request, const SharedRun& run);
    void beginShift();
    void previewShift(const std::optional<Eigen::Vector2d>& shiftPx);
    void startPreview();
    void showPreview();
    void settleShift();
    void follow();
    void showState();

    CaseDocument& document_;
    ViewSync& sync_;
    ui::WindowActions& actions_;
    ui::AngiogramPanel& panel_;
    ui::AngiogramView& view_;
    ui::BottomStrip& strip_;
    Notices& notices_;
    ui::MaskShiftTool* shiftTool_;
    std::optional<Request> request_;   ///< newest, not yet answered
    std::optional<Request> computing_;
    std::shared_ptr<std::atomic<bool>> stop_;
    QFutureWatcher<Outcome> run_;
    TreatedRuns made_;
    QFutureWatcher<Picture> preview_;
    std::optional<core::SubtractionPlan> wantedPreview_;
    bool isShiftFound_ = true;   ///< false: the automatic shift of the frame, where the hand begins, is on its way
    Eigen::Vector2d shiftBegan_ = Eigen::Vector2d::Zero();   ///< what the case or the search says
    QTimer rest_;
    bool isPreviewNew_ = false;   ///< its grey values are not those on screen
};

}   // namespace angiopose::app