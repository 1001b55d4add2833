#pragma once

#include "app/document/case_document.h"
#include "app/jobs/evaluation_job.h"
#include "app/jobs/job.h"
#include "app/jobs/trace_job.h"
#include "app/showing/pose_preview.h"
#include "app/texts/deformed_vessels.h"
#include "ui/plots/frame_bars.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/views/verdict_chip.h"

#include <QObject>

#include <optional>

namespace angiopose::ui {
class AngiogramView;
class BottomStrip;
class BranchPanel;
class RegistrationPanel;
class SliceModel;
class TreeView;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Keeps the views of the window in sync with the document and the previewed pose; redraws only what has changed.
class ViewSync : public QObject {
    Q_OBJECT
public:
    /// Parts of the main window that this class updates.
    struct Ui {
        ui::AngiogramView& view;
        ui::TreeView& treeView;
        ui::SliceModel& slices;
        ui::BranchPanel& branches;
        ui::RegistrationPanel& registration;
        ui::BottomStrip& strip;
    };
    ViewSync(const CaseDocument& document, const PosePreview& preview, const Ui& ui, QObject* parent = nullptr);

    void refresh();
    void showMarks(const ui::BranchMarks& marks);
    void showTarget(const SharedCenterline& target);
    void showAssessment(const SharedEvaluation& evaluation);   ///< null shows no residual colors
    /// Sets the verdict on the document's pose. While another pose is shown, the chip describes that one instead. An
    /// empty string hides the chip.
    void showVerdict(ui::VerdictTone tone, const QString& label);
    void showFrame(int frame);   ///< shows any frame of the open cine run, e.g. during playback, without changing the
                                 ///< document's frame
    int shownFrame() const { return shownFrame_; }
    const std::vector<int>& suggestedMasks() const
    {
        return suggestedMasks_;
    }   ///< suggested mask frames of the cine run; valid after `opacificationMeasured`
    const ui::FrameCurve& frameCurve() const { return frameCurve_; }
    void setIdentityHidden(bool hidden);

signals:
    void opacificationMeasured();   ///< emitted when `frameCurve` and `suggestedMasks` are available
    void frameShown(int frame);
    void poseShown(const core::RigidTransform& cameraFromPatient);   ///< pose of the document or of a preview

private:
    struct OpacificationResult {
        std::vector<double> opacification;
        std::vector<int> masks;
    };
    void showTree();
    void showShape();
    void drawTree();
    void showAngiogram();
    void clearFrame();
    void showCamera();
    void updateFromPreview();
    void showPose();
    void showResidualColors();
    void showChip();
    bool isPreviewPose() const;
    void colorByMotion(double mmPerPx);
    void colorByResiduals(double scalePx, double mmPerPx);
    void showCornerTexts();
    void showFrameNote();
    void measureOpacification();
    void setOpacification(const OpacificationResult& opacificationResult);

    const CaseDocument& document_;
    const PosePreview& preview_;
    Ui ui_;
    std::shared_ptr<const core::VesselTree> shownTree_;
    std::vector<int> shownHidden_;
    DrawnVessels drawnVessels_;
    SharedCenterline target_;
    std::shared_ptr<const core::Angiogram> shownAngiogram_;
    std::optional<core::ProjectionCamera> shownCamera_;
    int shownFrame_ = -1;
    bool isGrayRangeChanged_ = false;   ///< true if the range of gray values of the next frame differs
    SharedEvaluation evaluation_;
    bool wasPreviewPose_ = false;
    double previewMedianMm_ = 0.0;   ///< median residual at the previewed pose, mm; 0 if unknown
    ui::VerdictChip* chip_;
    ui::VerdictTone tone_ = ui::VerdictTone::Doubtful;
    QString verdict_;
    bool isMotionColored_ = false;
    bool identityHidden_ = false;
    std::shared_ptr<const core::Angiogram> measuredRun_;
    ui::FrameCurve frameCurve_;
    std::vector<int> suggestedMasks_;
    Job<OpacificationResult> opacification_;
};

}   // namespace angiopose::app
