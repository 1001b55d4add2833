#include "ui/scenes/overlay_scene.h"

#include "ui/scenes/fill_strokes.h"
#include "ui/scenes/grey_frame.h"
#include "ui/scenes/overlay_strokes.h"
#include "ui/scenes/radiograph_tint.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace angiopose::ui {
namespace {

/// The angiogram as the canvas shows it, kept until another part, size or grey is asked for.
struct Backdrop {
    std::vector<std::uint32_t> pixels;
    ViewRect rect;
    std::pair<int, int> size{0, 0};
    Interpolation interpolation = Interpolation::Smooth;
    std::uint64_t frameRevision = 0;

    const std::vector<std::uint32_t>& of(const GreyFrame& frame, const ViewRect& wantedRect, Interpolation wanted,
                                         Canvas canvas)
    {
        const std::pair wantedSize{canvas.width, canvas.height};
        if (frameRevision == frame.revision() && rect == wantedRect && size == wantedSize && interpolation == wanted) {
            return pixels;
        }
        frameRevision = frame.revision();
        rect = wantedRect;
        size = wantedSize;
        interpolation = wanted;
        const Color& around = palette(ThemeMode::Dark).canvas;
        pixels.assign(canvas.pixelCount(), packed(around));
        if (frame.width() > 0 && frame.height() > 0) {
            resampleFrame(frame.grey(), rect, interpolation, around, {pixels.data(), canvas.width, canvas.height});
        }
        return pixels;
    }
};

/// The overlay's triangles for one view and size.
struct Strokes {
    StrokeMesh mesh;
    std::uint64_t revision = 0;
    ViewRect rect;
    std::pair<int, int> size{0, 0};
};

}   // namespace

struct OverlayScene::Parts {
    core::VesselTree tree;
    core::ProjectionCamera camera;
    core::RigidTransform cameraFromPatient;
    OverlayContent content;
    bool isProjectionStale = true;
    GreyFrame frame;
    Interpolation interpolation = Interpolation::Smooth;
    ViewRect viewRect{-0.5, 511.5, -0.5, 511.5};
    std::uint64_t revision = 1;
    Cutout cutout;
    RadiographTint radiograph;
    Backdrop backdrop;
    Strokes strokes;

    void project()
    {
        if (std::exchange(isProjectionStale, false)) {
            content.tree =
                !core::findProblem(camera) ? projectedTree(tree, camera, cameraFromPatient) : ProjectedTree{};
            content.depthRange = depthRangeOf(content.tree);
        }
    }
    void markProjectionStale()
    {
        isProjectionStale = true;
        ++revision;
    }
    const StrokeMesh& meshFor(int width, int height)
    {
        const std::pair size{width, height};
        if (strokes.revision != revision || !(strokes.rect == viewRect) || strokes.size != size) {
            project();
            strokes = {overlayStrokes(content, {viewRect, width, height}), revision, viewRect, size};
        }
        return strokes.mesh;
    }
};

OverlayScene::OverlayScene() : parts_(std::make_unique<Parts>()) {}

OverlayScene::~OverlayScene() = default;

void OverlayScene::setFrame(const core::ImageF& frame)
{
    parts_->frame.setPixels(frame);
}

void OverlayScene::setWindowLevel(double window, double level)
{
    parts_->frame.setRange({level - 0.5 * window, level + 0.5 * window});
}

void OverlayScene::setInverted(bool inverted)
{
    parts_->frame.setInverted(inverted);
}

void OverlayScene::setInterpolation(Interpolation interpolation)
{
    parts_->interpolation = interpolation;
}

void OverlayScene::setTree(const core::VesselTree& tree)
{
    parts_->tree = tree;
    parts_->markProjectionStale();
}

void OverlayScene::setCamera(const core::ProjectionCamera& camera)
{
    parts_->camera = camera;
    parts_->markProjectionStale();
}

void OverlayScene::setPose(const core::RigidTransform& cameraFromPatient)
{
    const core::RigidTransform& former = parts_->cameraFromPatient;
    if (former.rotation != cameraFromPatient.rotation || former.translation != cameraFromPatient.translation) {
        parts_->cameraFromPatient = cameraFromPatient;
        parts_->markProjectionStale();
    }
}

void OverlayScene::setMarks(const BranchMarks& marks)
{
    if (!(parts_->content.marks == marks)) {
        parts_->content.marks = marks;
        ++parts_->revision;
    }
}

void OverlayScene::setMode(OverlayMode mode)
{
    parts_->content.mode = mode;
    ++parts_->revision;
}

OverlayMode OverlayScene::mode() const
{
    return parts_->content.mode;
}

void OverlayScene::setVeiled(bool veiled)
{
    parts_->content.isVeiled = veiled;
    ++parts_->revision;
}

DepthCue OverlayScene::depthCue() const
{
    return parts_->content.depthCue;
}

const Cutout& OverlayScene::cutout() const
{
    return parts_->cutout;
}

void OverlayScene::setDepthCue(DepthCue cue)
{
    parts_->content.depthCue = cue;
    ++parts_->revision;
}

void OverlayScene::setCutout(const Cutout& cutout)
{
    parts_->cutout = cutout;
}

void OverlayScene::setOpacity(double opacity)
{
    parts_->content.opacity = std::clamp(opacity, 0.0, 1.0);
    ++parts_->revision;
}

void OverlayScene::setRadiograph(const core::ImageF& radiograph)
{
    parts_->radiograph.setRadiograph(radiograph);
    ++parts_->revision;
}

bool OverlayScene::hasRadiograph() const
{
    return !parts_->radiograph.isEmpty();
}

void OverlayScene::setLineWidthPx(double devicePixels)
{
    if (parts_->content.lineWidthPx != devicePixels) {
        parts_->content.lineWidthPx = devicePixels;
        ++parts_->revision;
    }
}

void OverlayScene::setTracedCenterline(const core::Centerline2d& traced)
{
    parts_->content.traced = traced;
    ++parts_->revision;
}

void OverlayScene::showTracedCenterline(bool shown)
{
    parts_->content.isTracedShown = shown;
    ++parts_->revision;
}

void OverlayScene::setResiduals(const std::map<int, std::vector<double>>& residualPx, double scaleMaximumPx)
{
    if (parts_->content.residualPx != residualPx || parts_->content.scaleMaximumPx != scaleMaximumPx) {
        parts_->content.residualPx = residualPx;
        parts_->content.scaleMaximumPx = scaleMaximumPx;
        ++parts_->revision;
    }
}

void OverlayScene::recolor()
{
    ++parts_->revision;
}

void OverlayScene::clearResiduals()
{
    setResiduals({}, 0.0);
}

void OverlayScene::setViewRect(const ViewRect& rect)
{
    parts_->viewRect = rect;
}

const core::ImageF& OverlayScene::frame() const
{
    return parts_->frame.pixels();
}

ViewRect OverlayScene::viewRect() const
{
    return parts_->viewRect;
}

double OverlayScene::lineWidthPx() const
{
    return parts_->content.lineWidthPx;
}

void OverlayScene::drawRows(Canvas canvas, int firstRow, int rowCount)
{
    Parts& p = *parts_;
    const double rowHeight = p.viewRect.height() / rowCount;
    ViewRect part = p.viewRect;
    part.top += rowHeight * firstRow;
    part.bottom = part.top + rowHeight * canvas.height;
    const std::vector<std::uint32_t>& bare = p.backdrop.of(p.frame, part, p.interpolation, canvas);
    const StrokeMesh& mesh = p.meshFor(canvas.width, rowCount);
    forBands(canvas.height, [&](const Rows& rows) {
        std::copy(bare.data() + (canvas.row(rows.from) - canvas.pixels),
                  bare.data() + (canvas.row(rows.to) - canvas.pixels), canvas.row(rows.from));
        if (!p.content.isVeiled) {
            p.radiograph.blend({p.frame.width(), p.frame.height(), part}, p.content.opacity, canvas, rows);
        }
        fillStrokes(mesh, rowCount - firstRow, canvas, rows);
        applyCutout(p.cutout, part, bare, canvas, rows);
    });
}

OverlayScene::Stamp OverlayScene::stamp() const
{
    const Parts& p = *parts_;
    return {p.revision, p.frame.revision(), p.viewRect, p.cutout, p.interpolation};
}

std::optional<int> OverlayScene::branchAt(const Eigen::Vector2d& imagePoint, double tolerancePx) const
{
    if (parts_->content.mode == OverlayMode::Hidden) {
        return std::nullopt;
    }
    parts_->project();
    return nearestBranch(parts_->content.tree, imagePoint, tolerancePx);
}

std::optional<ViewRect> OverlayScene::extentOf(int branchId) const
{
    parts_->project();
    return ui::extentOf(parts_->content.tree, branchId);
}

bool OverlayScene::treePasses(const ViewRect& part) const
{
    parts_->project();
    return parts_->content.mode != OverlayMode::Hidden && passesThrough(parts_->content.tree, part);
}

}   // namespace angiopose::ui