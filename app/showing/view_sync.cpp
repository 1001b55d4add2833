#include "app/showing/view_sync.h"

#include "app/showing/vessels_in_view.h"
#include "app/texts/overlay_image.h"
#include "app/words/view_words.h"
#include "core/evaluation/trial/branch_distances.h"
#include "core/tracing/angiogram/run/subtract_run.h"
#include "core/tracing/angiogram/run/suggest_frame.h"
#include "ui/panels/bottom_strip.h"
#include "ui/panels/branch_panel.h"
#include "ui/panels/registration_panel.h"
#include "ui/slices/slice_model.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

double sourceToDetectorMm(const core::Case& current)
{
    // The value only serves to draw the detector, so a typical C-arm is a sufficient fallback.
    return current.shown().geometry.cArm.sourceToDetectorMm.value.value_or(1000.0);
}

QString previewWords(PreviewSource whose)
{
    switch (whose) {
        case PreviewSource::Start:
            return ViewSync::tr("initial pose");
        case PreviewSource::Replay:
            return ViewSync::tr("a registration step");
        case PreviewSource::Swing:
            return ViewSync::tr("a pose within image noise");
        case PreviewSource::Solution:
            return ViewSync::tr("another solution");
        case PreviewSource::Snapshot:
            return ViewSync::tr("a snapshot");
        case PreviewSource::Frame:
            return ViewSync::tr("pose of this frame");
        case PreviewSource::Drag:
        case PreviewSource::Run:
            break;
    }
    return ViewSync::tr("another pose");
}

/// Returns the bar heights relative to that of the peak-opacification frame.
std::vector<double> relativeToPeak(std::vector<double> shares)
{
    const double peak = shares.empty() ? 0.0 : *std::ranges::max_element(shares);
    for (double& share : shares) {
        share = peak > 0.0 ? share / peak : 0.0;
    }
    return shares;
}

}   // namespace

ViewSync::ViewSync(const CaseDocument& document, const PosePreview& preview, const Ui& ui, QObject* parent)
    : QObject(parent),
      document_(document),
      preview_(preview),
      ui_(ui),
      chip_(new ui::VerdictChip(ui.view)),
      opacification_([this](const OpacificationResult& opacificationResult) { setOpacification(opacificationResult); })
{
    connect(&preview, &PosePreview::changed, this, &ViewSync::updateFromPreview);
    ui::keepTranslated(this, [this] {
        showFrameNote();
        showCornerTexts();
        showChip();
    });
}

void ViewSync::refresh()
{
    const core::Case& current = document_.current();
    if (current.shown().angiogram != shownAngiogram_) {
        showAngiogram();
    }
    if (current.vessels.tree != shownTree_ || current.vessels.hiddenBranchIds != shownHidden_) {
        showTree();
    }
    showCamera();
    if (current.shown().frame != shownFrame_) {
        showFrame(current.shown().frame);
    }
    if (!preview_.shown()) {
        showPose();
    }
    showShape();
    ui_.view.setOrientationKnown(shownCamera_ && isOrientationKnown(current.shown(), current.vessels));
    showCornerTexts();
}

void ViewSync::showTree()
{
    shownTree_ = document_.current().vessels.tree;
    shownHidden_ = document_.current().vessels.hiddenBranchIds;
    const core::VesselTree tree = shownTree_ ? *shownTree_ : core::VesselTree{};
    ui::AngiogramView& view = ui_.view;
    view.scene().clearResiduals();
    drawTree();
    view.setPivot(shownTree_ ? core::centroidInPatient(tree) : Eigen::Vector3d::Zero());
    ui_.branches.showTree(tree);
}

/// Shows or hides the deformed vessels, which are valid only for the pose from which they were computed.
void ViewSync::showShape()
{
    const core::Case& current = document_.current();
    const auto known = deformationForPose(current.shown(), current.vessels, preview_.pose());
    if (known == drawnVessels_.known && (!known || preview_.shape() == drawnVessels_.shape)) {
        return;
    }
    drawTree();
    showResidualColors();
    showCornerTexts();
}

void ViewSync::drawTree()
{
    const core::Case& current = document_.current();
    drawnVessels_ = vesselsToDraw(current.shown(), current.vessels, preview_.pose(), preview_.shape());
    const core::VesselTree tree = core::withoutBranches(drawnVessels_.tree, shownHidden_);
    ui_.view.scene().setTree(tree);
    ui_.view.redraw();
    ui_.treeView.scene().setTree(tree);
    ui_.treeView.requestRender();
}

void ViewSync::showAngiogram()
{
    shownAngiogram_ = document_.current().shown().angiogram;
    shownFrame_ = -1;
    if (!shownAngiogram_) {
        clearFrame();
    }
    if (measuredRun_ == core::storedRunOf(document_.current().shown())) {
        isGrayRangeChanged_ =
            shownAngiogram_ != nullptr;   // the same cine run was switched between subtracted and native
    } else {
        measureOpacification();   // measured on the stored frames, which subtraction does not change
    }
}

void ViewSync::showCamera()
{
    const auto camera = core::cameraOf(document_.current().shown());
    const std::optional<core::ProjectionCamera> known = camera ? std::optional(camera.value()) : std::nullopt;
    if (known == shownCamera_) {
        return;
    }
    shownCamera_ = known;
    ui_.view.setCamera(known.value_or(core::ProjectionCamera()));
    ui_.treeView.scene().setCamera(known.value_or(core::ProjectionCamera()),
                                   known ? sourceToDetectorMm(document_.current()) : 0.0);
    ui_.treeView.requestRender();
}

/// Clears the displayed frame if the case no longer has an image.
void ViewSync::clearFrame()
{
    ui_.view.setFrame({});
    ui_.view.setFramePosition(0, 0);
    ui_.treeView.scene().setFrame({});
    ui_.treeView.requestRender();
}

void ViewSync::showFrame(int frame)
{
    shownFrame_ = frame;
    if (shownAngiogram_ && frame >= 0 && frame < shownAngiogram_->frameCount()) {
        const core::ImageF& image = shownAngiogram_->frames[static_cast<std::size_t>(frame)];
        ui_.view.setFrame(image);
        if (std::exchange(isGrayRangeChanged_, false)) {
            ui_.view.autoWindowLevel();
        }
        ui_.view.setFramePosition(frame, shownAngiogram_->frameCount());
        ui_.treeView.scene().setFrame(image);
        ui_.treeView.requestRender();
    }
    ui_.strip.showCurrentFrame(frame);
    showFrameNote();
    emit frameShown(frame);
}

void ViewSync::showPose()
{
    const core::RigidTransform& cameraFromPatient = preview_.pose();
    ui_.view.setPose(cameraFromPatient);
    ui_.treeView.scene().setPose(cameraFromPatient);
    ui_.view.redraw();
    ui_.treeView.requestRender();
    emit poseShown(cameraFromPatient);
}

void ViewSync::updateFromPreview()
{
    const bool isMotionNew = std::exchange(isMotionColored_, preview_.isMotionColored()) != isMotionColored_;
    const bool isOther = isPreviewPose();
    if (std::exchange(wasPreviewPose_, isOther) || isOther || isMotionNew) {
        showResidualColors();
        showCornerTexts();
    }
    showPose();
    showShape();
    showChip();
}

/// Returns whether a preview is shown to which the evaluation of the document's pose does not apply.
bool ViewSync::isPreviewPose() const
{
    return preview_.shown() && preview_.colors() == ResidualColors::Hidden;
}

void ViewSync::showVerdict(ui::VerdictTone tone, const QString& label)
{
    tone_ = tone;
    verdict_ = label;
    showChip();
}

void ViewSync::showChip()
{
    if (!isPreviewPose() || document_.isInTrial()) {
        chip_->showVerdict(tone_, document_.isInTrial() ? QString() : verdict_);
        return;
    }
    const QString label = tr("Preview: %1").arg(previewWords(*preview_.shown()));
    chip_->showVerdict(ui::VerdictTone::Doubtful,
                       previewMedianMm_ > 0.0
                           ? tr("%1 · median of the whole tree %2 mm").arg(label, ui::numberText(previewMedianMm_, 2))
                           : label);
}

void ViewSync::showMarks(const ui::BranchMarks& marks)
{
    ui_.view.scene().setMarks(marks);
    ui_.view.redraw();
    ui_.treeView.scene().setMarks(marks);
    ui_.treeView.requestRender();
    ui_.branches.showMarks(marks);
    ui_.slices.setMarks(marks);
    const auto isUsed = [&marks](int id) { return !marks.excluded.contains(id); };
    ui_.registration.showAuxiliary(static_cast<int>(std::ranges::count_if(marks.auxiliary, isUsed)));
}

void ViewSync::showTarget(const SharedCenterline& target)
{
    target_ = target;
    ui_.view.scene().setTracedCenterline(target ? *target : core::Centerline2d{});
    ui_.view.redraw();
}

void ViewSync::showAssessment(const SharedEvaluation& evaluation)
{
    evaluation_ = evaluation;
    showResidualColors();
    const core::Case& current = document_.current();
    if (!evaluation_ || !shownCamera_ || !current.vessels.tree) {
        ui_.branches.showResiduals({}, 0.0);
        return;
    }
    const double depthMm = depthOfTreeMm(current.shown(), current.vessels);
    const double mmPerPx = core::millimetersPerPixel(*shownCamera_, depthMm);
    std::map<int, double> residualMm;
    for (const core::BranchResidual& branch : evaluation_->result.branches) {
        residualMm[branch.branchId] = branch.medianPx * mmPerPx;
    }
    ui_.branches.showResiduals(residualMm, residualScaleMaximumPx(*shownCamera_, depthMm) * mmPerPx);
}

void ViewSync::showResidualColors()
{
    ui::AngiogramView& view = ui_.view;
    const core::Case& current = document_.current();
    const bool isOfOtherFrame = preview_.shown() == PreviewSource::Frame;   // vessels of that frame are not traced
    const bool isKnown =
        isPreviewPose() ? target_ && !isOfOtherFrame && !document_.isInTrial() : evaluation_ != nullptr;
    previewMedianMm_ = 0.0;
    if (!isKnown || !shownCamera_ || !current.vessels.tree) {
        view.scene().clearResiduals();
        view.setResidualScale(0.0, 0.0);
    } else {
        const double depthMm = depthOfTreeMm(current.shown(), current.vessels);
        const double mmPerPx = core::millimetersPerPixel(*shownCamera_, depthMm);
        if (drawnVessels_.known && isMotionColored_) {
            colorByMotion(mmPerPx);
        } else {
            colorByResiduals(residualScaleMaximumPx(*shownCamera_, depthMm), mmPerPx);
        }
    }
    view.redraw();
}

void ViewSync::colorByMotion(double mmPerPx)
{
    const double endMm = drawnVessels_.motion.scaleMaximumMm;
    ui_.view.scene().setResiduals(drawnVessels_.motion.distanceMm, endMm);
    ui_.view.setResidualScale(endMm / mmPerPx, endMm);
}

/// Colors the vessels, as drawn at the pose on screen, by their residuals; the stored evaluation covers only the rigid
/// vessels at the document's pose.
void ViewSync::colorByResiduals(double scalePx, double mmPerPx)
{
    const bool isOther = isPreviewPose();
    const bool isJudged = !isOther && (drawnVessels_.shape != VesselShape::Deformed || !target_);
    const auto residualPx = isJudged
                                ? evaluation_->residualPx
                                : core::branchDistances(drawnVessels_.tree, *target_, *shownCamera_, preview_.pose());
    if (isOther) {
        previewMedianMm_ = mmPerPx * core::medianOf(residualPx);
    }
    ui_.view.scene().setResiduals(residualPx, scalePx);
    ui_.view.setResidualScale(scalePx, scalePx * mmPerPx);
}

void ViewSync::setIdentityHidden(bool hidden)
{
    identityHidden_ = hidden;
    showCornerTexts();
}

void ViewSync::showCornerTexts()
{
    const Identity identity = identityHidden_ ? Identity::Hidden : Identity::Shown;
    CornerLines lines = cornerLines(document_.current(), identity);
    if (drawnVessels_.known) {
        lines.bottomLeft = shapeLines(drawnVessels_);
        lines.scaleHeading = isMotionColored_ ? std::optional(motionHeading()) : std::nullopt;
    }
    ui_.view.setCornerTexts(windowTexts(lines));
}

void ViewSync::showFrameNote()
{
    if (!shownAngiogram_) {
        ui_.strip.showFrameNote({});
        return;
    }
    const int count = shownAngiogram_->frameCount();
    ui_.strip.showFrameNote(count > 1 ? tr("Opacification by frame · frame %1 of %2 · peak: %3")
                                            .arg(shownFrame_ + 1)
                                            .arg(count)
                                            .arg(shownAngiogram_->suggestedFrame + 1)
                                      : tr("Single frame"));
}

void ViewSync::measureOpacification()
{
    measuredRun_ = core::storedRunOf(document_.current().shown());
    frameCurve_ = {};
    suggestedMasks_.clear();
    ui_.strip.showFrames(frameCurve_);
    opacification_.drop();
    if (measuredRun_ && measuredRun_->frameCount() > 1) {
        opacification_.start([run = measuredRun_](JobLink<double>&) -> core::Result<OpacificationResult> {
            return OpacificationResult{core::opacificationCurve(run->frames, run->polarity, run->shutter),
                                       core::suggestMaskFrames(run->frames, run->polarity, run->shutter)};
        });
    }
    emit opacificationMeasured();
}

void ViewSync::setOpacification(const OpacificationResult& opacificationResult)
{
    frameCurve_ = {relativeToPeak(opacificationResult.opacification), measuredRun_->suggestedFrame,
                   measuredRun_->frameTimeMs, measuredRun_->rWaveFrames};
    suggestedMasks_ = opacificationResult.masks;
    ui_.strip.showFrames(frameCurve_);
    emit opacificationMeasured();
}

}   // namespace angiopose::app
