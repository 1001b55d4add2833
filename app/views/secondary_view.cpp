#include "app/views/secondary_view.h"

#include "app/showing/vessels_in_view.h"
#include "app/texts/overlay_image.h"
#include "app/words/measure_words.h"
#include "app/words/view_words.h"
#include "core/case/registration_input.h"
#include "core/evaluation/trial/branch_distances.h"
#include "ui/places/side_by_side.h"
#include "ui/views/angiogram_view.h"

#include <chrono>
#include <utility>

namespace angiopose::app {
namespace {

constexpr auto restOfOthers =
    std::chrono::milliseconds(150);   ///< leaves processor time for drawing and for the shown view

}   // namespace

SecondaryViewController::SecondaryViewController(const Parts& parts, QObject* parent)
    : QObject(parent), parts_(parts), job_(restOfOthers)
{
    connect(&job_, &EvaluationJob::evaluated, this,
            [this](const SharedEvaluation& evaluation) { showResiduals(*evaluation); });
    connect(&job_, &EvaluationJob::failed, this, [this] { parts_.pane.image().scene().clearResiduals(); });
    connect(&parts_.pane.image(), &ui::AngiogramView::windowLevelChanged, this, [this](double window, double level) {
        if (isWindowLevelManual_) {
            parts_.overlayStyle.brightness().store(view(), window, level);
        }
    });
}

void SecondaryViewController::show(std::size_t viewIndex)
{
    viewIndex_ = viewIndex;
    showTree();
    showImage();
    const auto camera = core::cameraOf(view());
    const bool isSeen = camera && angiogram_;   // vessels are drawn only over an image
    const core::ProjectionCamera known = isSeen ? camera.value() : core::ProjectionCamera();
    ui::AngiogramView& image = parts_.pane.image();
    if (!(known == image.camera())) {
        image.setCamera(known);
    }
    image.setOrientationKnown(isSeen && isOrientationKnown(view(), current().vessels));
    showPose();
}

void SecondaryViewController::showTree()
{
    const core::Vessels& vessels = current().vessels;
    if (vessels.tree == tree_ && vessels.hiddenBranchIds == hidden_) {
        return;
    }
    tree_ = vessels.tree;
    hidden_ = vessels.hiddenBranchIds;
    hideResiduals();   // the colors of the previous tree would be misleading
    ui::AngiogramView& image = parts_.pane.image();
    drawTree();
    image.setPivot(tree_ ? core::centroidInPatient(*tree_) : Eigen::Vector3d(Eigen::Vector3d::Zero()));
}

/// Shows or hides the deformed vessels, which are valid only for the pose from which they were computed.
void SecondaryViewController::showShape()
{
    const auto known = deformationForPose(view(), current().vessels, pose_);
    if (known != drawnVessels_.known || (known && parts_.preview.shape() != drawnVessels_.shape)) {
        hideResiduals();
        drawTree();
    }
}

void SecondaryViewController::drawTree()
{
    drawnVessels_ = vesselsToDraw(view(), current().vessels, pose_, parts_.preview.shape());
    ui::AngiogramView& image = parts_.pane.image();
    image.scene().setTree(core::withoutBranches(drawnVessels_.tree, hidden_));
    CornerLines lines;
    lines.bottomLeft = shapeLines(drawnVessels_);
    image.setCornerTexts(windowTexts(lines));
    image.redraw();
}

void SecondaryViewController::showImage()
{
    const bool isNew = std::exchange(angiogram_, view().angiogram) != view().angiogram;
    if (isNew || frame_ != view().frame) {
        hideResiduals();
        parts_.pane.image().scene().setTracedCenterline({});
        isWindowLevelManual_ = isWindowLevelManual_ && !isNew;
        showFrame();
    }
    if (isNew && angiogram_) {
        ui::AngiogramView& image = parts_.pane.image();
        image.fitToWindow();
        if (const auto range = parts_.overlayStyle.brightness().rangeOf(view())) {
            image.setWindowLevel(range->window(), range->level());
        } else {
            image.autoWindowLevel();
        }
    }
    isWindowLevelManual_ = angiogram_ != nullptr;
}

void SecondaryViewController::showFrame()
{
    frame_ = view().frame;
    const int count = angiogram_ ? angiogram_->frameCount() : 0;
    const bool isThere = frame_ >= 0 && frame_ < count;
    parts_.pane.image().setFrame(isThere ? angiogram_->frames[static_cast<std::size_t>(frame_)] : core::ImageF());
    parts_.pane.showFrame(frame_, count);
}

void SecondaryViewController::showPose()
{
    pose_ = parts_.preview.poseOfView(viewIndex_);
    parts_.pane.image().setPose(pose_);
    showShape();
    parts_.pane.image().setMarks(windowMarks({view(), tree_.get(), pose_}, frame_));
    parts_.pane.image().setPlacedMarks(
        windowPlacedMarks({current(), viewIndex_, frame_, parts_.preview.shape(),
                           [this](std::size_t viewIndex) { return parts_.preview.poseOfView(viewIndex); }}));
    showColors();
}

void SecondaryViewController::showColors()
{
    const auto target = parts_.views.targetOf(viewIndex_);
    const bool areHidden = parts_.preview.colors() == ResidualColors::Hidden || parts_.document.isLocked();
    if (!target || !tree_ || areHidden) {
        hideResiduals();
        return;
    }
    if (drawnVessels_.known && parts_.preview.isMotionColored()) {
        hideResiduals();
        parts_.pane.image().scene().setResiduals(drawnVessels_.motion.distanceMm, drawnVessels_.motion.scaleMaximumMm);
        return;
    }
    ColorInputs inputs{viewKey(view()), tree_, current().vessels.excludedBranchIds, target};
    inputs.key.pose = pose_.matrix();
    if (coloredFor_ == inputs) {
        return;
    }
    auto input = core::makeRegistrationInput(view(), current().vessels, *target);
    if (!input) {
        hideResiduals();
        return;
    }
    coloredFor_ = std::move(inputs);
    parts_.pane.image().scene().setTracedCenterline(*target);
    job_.request({std::move(input).value(), pose_});
}

void SecondaryViewController::showResiduals(const core::PoseEvaluation& evaluation)
{
    ui::AngiogramView& image = parts_.pane.image();
    const bool isDeformed = drawnVessels_.shape == VesselShape::Deformed && coloredFor_;
    image.scene().setResiduals(
        isDeformed ? core::branchDistances(drawnVessels_.tree, *coloredFor_->target, image.camera(), pose_)
                   : evaluation.residualPx,
        residualScaleMaximumPx(image.camera(), depthOfTreeMm(view(), current().vessels)));
    image.redraw();
}

void SecondaryViewController::hideResiduals()
{
    job_.cancel();
    coloredFor_.reset();
    parts_.pane.image().scene().clearResiduals();
    parts_.pane.image().redraw();
}

void SecondaryViewController::applyDisplaySettings()
{
    ui::AngiogramView& image = parts_.pane.image();
    image.copyAppearance(parts_.shown);
    image.scene().setMode(parts_.overlayStyle.lines());
    image.redraw();
}

void SecondaryViewController::clear()
{
    hideResiduals();
    isWindowLevelManual_ = false;
    tree_.reset();
    drawnVessels_ = {};
    hidden_.clear();
    angiogram_.reset();
    frame_ = -1;
    ui::AngiogramView& image = parts_.pane.image();
    image.scene().setTree({});
    image.scene().setTracedCenterline({});
    image.setMarks({});
    image.setPlacedMarks({});
    image.setCornerTexts({});
    image.setFrame({});
}

}   // namespace angiopose::app
