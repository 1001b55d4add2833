#include "app/views/other_view.h"

#include "app/showing/vessels_in_view.h"
#include "app/texts/overlay_picture.h"
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
    std::chrono::milliseconds(150);   ///< leaves processor time for drawing and the shown view

}   // namespace

OtherView::OtherView(const Parts& parts, QObject* parent) : QObject(parent), on_(parts), job_(restOfOthers)
{
    connect(&job_, &JudgeJob::judged, this, [this](const SharedJudgement& judgement) { showResiduals(*judgement); });
    connect(&job_, &JudgeJob::failed, this, [this] { on_.pane.image().scene().clearResiduals(); });
    connect(&on_.pane.image(), &ui::AngiogramView::windowLevelChanged, this, [this](double window, double level) {
        if (isBrightnessOwn_) {
            on_.look.brightness().keep(view(), window, level);
        }
    });
}

void OtherView::show(std::size_t place)
{
    place_ = place;
    showTree();
    showImage();
    const auto camera = core::cameraOf(view());
    const bool isSeen = camera && angiogram_;   // vessels are drawn only over an image
    const core::ProjectionCamera known = isSeen ? camera.value() : core::ProjectionCamera();
    ui::AngiogramView& image = on_.pane.image();
    if (!(known == image.camera())) {
        image.setCamera(known);
    }
    image.setOrientationKnown(isSeen && isOrientationKnown(view(), current().vessels));
    showPose();
}

void OtherView::showTree()
{
    const core::Vessels& vessels = current().vessels;
    if (vessels.tree == tree_ && vessels.hiddenBranchIds == hidden_) {
        return;
    }
    tree_ = vessels.tree;
    hidden_ = vessels.hiddenBranchIds;
    hideResiduals();   // the colors of the previous tree would be misleading
    ui::AngiogramView& image = on_.pane.image();
    drawTree();
    image.setPivot(tree_ ? core::centroidInPatient(*tree_) : Eigen::Vector3d(Eigen::Vector3d::Zero()));
}

/// Shows or hides the deformed vessels, which are valid only for the pose from which they were computed.
void OtherView::showShape()
{
    const auto known = drawableDeformation(view(), current().vessels, pose_);
    if (known != drawn_.known || (known && on_.preview.shape() != drawn_.shape)) {
        hideResiduals();
        drawTree();
    }
}

void OtherView::drawTree()
{
    drawn_ = drawnVessels(view(), current().vessels, pose_, on_.preview.shape());
    ui::AngiogramView& image = on_.pane.image();
    image.scene().setTree(core::without(drawn_.tree, hidden_));
    CornerLines lines;
    lines.bottomLeft = shapeLines(drawn_);
    image.setCornerTexts(windowTexts(lines));
    image.redraw();
}

void OtherView::showImage()
{
    const bool isNew = std::exchange(angiogram_, view().angiogram) != view().angiogram;
    if (isNew || frame_ != view().frame) {
        hideResiduals();
        on_.pane.image().scene().setTracedCenterline({});
        isBrightnessOwn_ = isBrightnessOwn_ && !isNew;
        showFrame();
    }
    if (isNew && angiogram_) {
        ui::AngiogramView& image = on_.pane.image();
        image.fitToWindow();
        if (const auto range = on_.look.brightness().rangeOf(view())) {
            image.setWindowLevel(range->window(), range->level());
        } else {
            image.autoWindowLevel();
        }
    }
    isBrightnessOwn_ = angiogram_ != nullptr;
}

void OtherView::showFrame()
{
    frame_ = view().frame;
    const int count = angiogram_ ? angiogram_->frameCount() : 0;
    const bool isThere = frame_ >= 0 && frame_ < count;
    on_.pane.image().setFrame(isThere ? angiogram_->frames[static_cast<std::size_t>(frame_)] : core::ImageF());
    on_.pane.showFrame(frame_, count);
}

void OtherView::showPose()
{
    pose_ = on_.preview.poseIn(place_);
    on_.pane.image().setPose(pose_);
    showShape();
    on_.pane.image().setMarks(windowMarks({view(), tree_.get(), pose_}, frame_));
    on_.pane.image().setPlacedMarks(
        windowPlacedMarks({current(), place_, frame_, on_.preview.shape(),
                           [this](std::size_t place) { return on_.preview.poseIn(place); }}));
    showColors();
}

void OtherView::showColors()
{
    const auto target = on_.views.targetOf(place_);
    const bool areHidden = on_.preview.colors() == ResidualColors::Hidden || on_.document.isLocked();
    if (!target || !tree_ || areHidden) {
        hideResiduals();
        return;
    }
    if (drawn_.known && on_.preview.isMotionColored()) {
        hideResiduals();
        on_.pane.image().scene().setResiduals(drawn_.motion.distanceMm, drawn_.motion.scaleMaximumMm);
        return;
    }
    Judged wanted{sightOf(view()), tree_, current().vessels.excludedBranchIds, target};
    wanted.sight.pose = pose_.matrix();
    if (judged_ == wanted) {
        return;
    }
    auto input = core::registrationInputOf(view(), current().vessels, *target);
    if (!input) {
        hideResiduals();
        return;
    }
    judged_ = std::move(wanted);
    on_.pane.image().scene().setTracedCenterline(*target);
    job_.request({std::move(input).value(), pose_});
}

void OtherView::showResiduals(const core::PoseJudgement& judgement)
{
    ui::AngiogramView& image = on_.pane.image();
    const bool isDeformed = drawn_.shape == VesselShape::Deformed && judged_;
    image.scene().setResiduals(
        isDeformed ? core::branchDistances(drawn_.tree, *judged_->target, image.camera(), pose_) : judgement.residualPx,
        residualScaleMaximumPx(image.camera(), depthOfTreeMm(view(), current().vessels)));
    image.redraw();
}

void OtherView::hideResiduals()
{
    job_.cancel();
    judged_.reset();
    on_.pane.image().scene().clearResiduals();
    on_.pane.image().redraw();
}

void OtherView::takeLook()
{
    ui::AngiogramView& image = on_.pane.image();
    image.takeLookOf(on_.shown);
    image.scene().setMode(on_.look.lines());
    image.redraw();
}

void OtherView::clear()
{
    hideResiduals();
    isBrightnessOwn_ = false;
    tree_.reset();
    drawn_ = {};
    hidden_.clear();
    angiogram_.reset();
    frame_ = -1;
    ui::AngiogramView& image = on_.pane.image();
    image.scene().setTree({});
    image.scene().setTracedCenterline({});
    image.setMarks({});
    image.setPlacedMarks({});
    image.setCornerTexts({});
    image.setFrame({});
}

}   // namespace angiopose::app
