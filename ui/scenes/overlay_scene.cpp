#include "ui/scenes/overlay_scene.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace angiopose::ui {
namespace {

DepthRange depthRangeOf(const ProjectedTree& tree)
{
    DepthRange range{1e30, -1e30};
    for (const ProjectedBranch& branch : tree) {
        for (const auto& run : branch.runs) {
            for (const ProjectedPoint& point : run) {
                range.nearMm = std::min(range.nearMm, point.depthMm);
                range.farMm = std::max(range.farMm, point.depthMm);
            }
        }
    }
    return range;
}

}   // namespace

struct OverlayScene::Parts {
    OverlayContent content;
    bool isProjectionStale = true;

    void project()
    {
        if (std::exchange(isProjectionStale, false)) {
            content.projected = !core::findProblem(content.camera)
                                    ? projectTree(content.tree, content.camera, content.cameraFromPatient)
                                    : ProjectedTree{};
            content.depthRange = depthRangeOf(content.projected);
        }
    }
    void markProjectionStale()
    {
        isProjectionStale = true;
        content.revision = nextRevision();
    }
    void markLinesStale()
    {
        content.revision = nextRevision();
        content.linesRevision = nextRevision();
    }
};

OverlayScene::OverlayScene() : parts_(std::make_unique<Parts>()) {}

OverlayScene::~OverlayScene() = default;

void OverlayScene::setFrame(const core::ImageF& frame)
{
    parts_->content.frame.setPixels(frame);
}

void OverlayScene::setWindowLevel(double window, double level)
{
    parts_->content.frame.setRange({level - 0.5 * window, level + 0.5 * window});
}

void OverlayScene::setInverted(bool inverted)
{
    parts_->content.frame.setInverted(inverted);
}

void OverlayScene::setInterpolation(Interpolation interpolation)
{
    parts_->content.interpolation = interpolation;
}

void OverlayScene::setTree(const core::VesselTree& tree)
{
    parts_->content.tree = tree;
    parts_->markProjectionStale();
    parts_->markLinesStale();
}

void OverlayScene::setCamera(const core::ProjectionCamera& camera)
{
    parts_->content.camera = camera;
    parts_->markProjectionStale();
}

void OverlayScene::setPose(const core::RigidTransform& cameraFromPatient)
{
    const core::RigidTransform& former = parts_->content.cameraFromPatient;
    if (former.rotation != cameraFromPatient.rotation || former.translation != cameraFromPatient.translation) {
        parts_->content.cameraFromPatient = cameraFromPatient;
        parts_->markProjectionStale();
    }
}

void OverlayScene::setMarks(const BranchMarks& marks)
{
    if (!(parts_->content.marks == marks)) {
        parts_->content.marks = marks;
        parts_->markLinesStale();
    }
}

void OverlayScene::setMode(OverlayMode mode)
{
    if (parts_->content.mode != mode) {
        parts_->content.mode = mode;
        parts_->content.revision = nextRevision();
    }
}

OverlayMode OverlayScene::mode() const
{
    return parts_->content.mode;
}

void OverlayScene::setOverlayHidden(bool hidden)
{
    parts_->content.isOverlayHidden = hidden;
    parts_->content.revision = nextRevision();
}

DepthCue OverlayScene::depthCue() const
{
    return parts_->content.depthCue;
}

const Cutout& OverlayScene::cutout() const
{
    return parts_->content.cutout;
}

void OverlayScene::setDepthCue(DepthCue cue)
{
    parts_->content.depthCue = cue;
    parts_->markLinesStale();
}

void OverlayScene::setCutout(const Cutout& cutout)
{
    parts_->content.cutout = cutout;
}

void OverlayScene::setOpacity(double opacity)
{
    parts_->content.opacity = std::clamp(opacity, 0.0, 1.0);
    parts_->content.revision = nextRevision();
}

void OverlayScene::setDrr(const core::ImageF& drr)
{
    parts_->content.drr.setDrr(drr);
    parts_->content.revision = nextRevision();
}

bool OverlayScene::hasDrr() const
{
    return !parts_->content.drr.isEmpty();
}

void OverlayScene::setLineWidthPx(double devicePixels)
{
    if (parts_->content.lineWidthPx != devicePixels) {
        parts_->content.lineWidthPx = devicePixels;
        parts_->content.revision = nextRevision();
    }
}

void OverlayScene::setTracedCenterline(const core::Centerline2d& traced)
{
    parts_->content.traced = traced;
    parts_->markLinesStale();
}

void OverlayScene::showTracedCenterline(bool shown)
{
    parts_->content.isTracedShown = shown;
    parts_->markLinesStale();
}

void OverlayScene::setResiduals(const std::map<int, std::vector<double>>& residualPx, double scaleMaximumPx)
{
    if (parts_->content.residualPx != residualPx || parts_->content.scaleMaximumPx != scaleMaximumPx) {
        parts_->content.residualPx = residualPx;
        parts_->content.scaleMaximumPx = scaleMaximumPx;
        parts_->markLinesStale();
    }
}

void OverlayScene::recolor()
{
    parts_->markLinesStale();
}

void OverlayScene::clearResiduals()
{
    setResiduals({}, 0.0);
}

void OverlayScene::copyAppearance(const OverlayScene& other)
{
    OverlayContent& own = parts_->content;
    const OverlayContent& source = other.parts_->content;
    const auto appearance = [](auto& content) {
        return std::tie(content.marks, content.depthCue, content.opacity, content.isTracedShown);
    };
    if (appearance(own) != appearance(source)) {
        appearance(own) = appearance(source);
        parts_->markLinesStale();
    }
    own.frame.setInverted(source.frame.isInverted());
}

void OverlayScene::setViewRect(const ViewRect& rect)
{
    parts_->content.viewRect = rect;
}

const core::ImageF& OverlayScene::frame() const
{
    return parts_->content.frame.pixels();
}

ViewRect OverlayScene::viewRect() const
{
    return parts_->content.viewRect;
}

double OverlayScene::lineWidthPx() const
{
    return parts_->content.lineWidthPx;
}

const OverlayContent& OverlayScene::content() const
{
    parts_->project();
    return parts_->content;
}

OverlayScene::Stamp OverlayScene::stamp() const
{
    const OverlayContent& content = parts_->content;
    return {content.revision, content.frame.revision(), content.viewRect, content.cutout, content.interpolation};
}

std::optional<int> OverlayScene::branchAt(const Eigen::Vector2d& imagePoint, double tolerancePx) const
{
    if (parts_->content.mode == OverlayMode::Hidden) {
        return std::nullopt;
    }
    parts_->project();
    return nearestBranch(parts_->content.projected, imagePoint, tolerancePx);
}

std::optional<ViewRect> OverlayScene::extentOf(int branchId) const
{
    parts_->project();
    return ui::extentOf(parts_->content.projected, branchId);
}

bool OverlayScene::treeIntersects(const ViewRect& part) const
{
    parts_->project();
    return parts_->content.mode != OverlayMode::Hidden && intersectsRect(parts_->content.projected, part);
}

}   // namespace angiopose::ui
