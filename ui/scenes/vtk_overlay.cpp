#include "ui/scenes/vtk_overlay.h"

#include "ui/scenes/frame_layer.h"
#include "ui/scenes/line_layer.h"
#include "ui/scenes/overlay_lines.h"
#include "ui/scenes/overlay_pens.h"
#include "ui/scenes/stroke_actor.h"

#include <vtkCamera.h>
#include <vtkCullerCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <cmath>
#include <numbers>

namespace angiopose::ui {
namespace {

/// Places a VTK camera at the X-ray source: a point in patient space (mm) appears at the pixel given by
/// `core::project`, and the part `rect` of the image fills the view.
void setPinhole(vtkCamera& view, const core::ProjectionCamera& camera, const core::RigidTransform& cameraFromPatient,
                const ViewRect& rect)
{
    const Eigen::Matrix3d& rotation = cameraFromPatient.rotation;
    const Eigen::Vector3d source = -rotation.transpose() * cameraFromPatient.translation;
    const Eigen::Vector3d ahead = source + rotation.row(2).transpose();
    const Eigen::Vector3d up = -rotation.row(1).transpose();   // negated, since v points down
    view.SetPosition(source.x(), source.y(), source.z());
    view.SetFocalPoint(ahead.x(), ahead.y(), ahead.z());
    view.SetViewUp(up.x(), up.y(), up.z());

    // Half extent of the view at depth 1, and offset of its center from the central ray in half extents; in mirrored
    // images, fx > 0.
    const double halfWidth = 0.5 * rect.width();
    const double halfHeight = 0.5 * rect.height();
    view.SetViewAngle(2.0 * std::atan(halfHeight / camera.fy) * 180.0 / std::numbers::pi);
    view.UseExplicitAspectRatioOn();
    view.SetExplicitAspectRatio((halfWidth / camera.fx) / (halfHeight / camera.fy));
    view.SetWindowCenter((0.5 * (rect.left + rect.right) - camera.cx) / halfWidth,
                         (camera.cy - 0.5 * (rect.top + rect.bottom)) / halfHeight);
}

/// Camera for traced curves if none is known: any camera works because the curves lie on the image.
core::ProjectionCamera usableCamera(const core::ProjectionCamera& camera)
{
    return !core::findProblem(camera) ? camera : core::ProjectionCamera{1000.0, 1000.0, 0.0, 0.0, 1, 1};
}

bool hasDashes(const BranchMarks& marks)
{
    return !marks.excluded.empty();
}

}   // namespace

struct VtkOverlay::Parts {
    vtkNew<vtkRenderer> renderer;
    vtkRenderWindow* window = nullptr;
    FrameLayer frame;
    LineData tree, glowing, traced;
    LineLayer inside{tree}, glow{glowing}, halo{tree}, core{tree}, tracedShade{traced}, tracedDots{traced};
    StrokeActor above;
    std::size_t aboveVertices = 0;
    std::uint64_t linesRevision = 0;
    std::uint64_t revision = 0;
    core::ProjectionCamera tracedFor;   ///< camera with which the traced curves were placed

    std::array<LineLayer*, 6> layers() { return {&inside, &glow, &halo, &core, &tracedShade, &tracedDots}; }
    void updateLines(const OverlayContent& content);
    void placeTraced(const OverlayContent& content);
    void showTree(const OverlayContent& content, const ImagePlacement& placement);
    void showTraced(const OverlayContent& content, const ImagePlacement& placement);
};

void VtkOverlay::Parts::updateLines(const OverlayContent& content)
{
    const bool isNew = linesRevision != content.linesRevision;
    if (isNew || (hasDashes(content.marks) && revision != content.revision)) {
        fillTreeLines(tree, content);
        fillGlowLines(glowing, content);
    }
    const core::ProjectionCamera camera = usableCamera(content.camera);
    if (content.isTracedShown && (isNew || !(tracedFor == camera))) {
        fillTracedLines(traced, content.traced, camera);
        tracedFor = camera;
    }
    linesRevision = content.linesRevision;
    revision = content.revision;
}

/// Keeps the traced curves fixed to the camera.
void VtkOverlay::Parts::placeTraced(const OverlayContent& content)
{
    vtkNew<vtkMatrix4x4> patientFromCamera;
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix = content.cameraFromPatient.inverse().matrix();
    patientFromCamera->DeepCopy(matrix.data());
    tracedShade.actor()->SetUserMatrix(patientFromCamera);
    tracedDots.actor()->SetUserMatrix(patientFromCamera);
}

void VtkOverlay::Parts::showTree(const OverlayContent& content, const ImagePlacement& placement)
{
    const bool isTube = content.mode == OverlayMode::Tube;
    const bool isCenter = content.mode == OverlayMode::Centerline;
    LinePass pass;
    pass.shape = isCenter ? LinePass::Shape::Center : LinePass::Shape::Edges;
    pass.lineWidthPx = (isCenter ? 1.0 : edgeWidth) * content.lineWidthPx;
    pass.dashPx = {static_cast<float>(branchDashes[0] * content.lineWidthPx),
                   static_cast<float>(branchDashes[1] * content.lineWidthPx)};
    pass.opacity = content.opacity;
    LinePass glowPass = pass;
    glowPass.widthGain = glowWidth;
    glowPass.fadePx = 0.0;
    glowPass.fadeGain = glowFade;
    LinePass haloPass = pass;
    haloPass.widthExtraPx = haloWidth * content.lineWidthPx;
    haloPass.fadePx = haloFadePx;
    haloPass.opacityGain = haloOpacity;
    haloPass.shade = palette(ThemeMode::Dark).canvas;
    if (content.depthCue != DepthCue::None) {
        pass.depth = content.depthRange;
    }
    LinePass insidePass = pass;
    insidePass.shape = LinePass::Shape::Inside;
    insidePass.opacityGain = insideOpacity;
    pass.hasEndDots = true;
    if (!tree.isEmpty()) {
        halo.show(haloPass, content, placement);
        core.show(pass, content, placement);
    }
    if (!glowing.isEmpty()) {
        glow.show(glowPass, content, placement);
    }
    if (isTube && !tree.isEmpty()) {
        inside.show(insidePass, content, placement);
    }
}

void VtkOverlay::Parts::showTraced(const OverlayContent& content, const ImagePlacement& placement)
{
    if (traced.isEmpty()) {
        return;
    }
    placeTraced(content);
    const double widthPx = tracedWidth * content.lineWidthPx;
    LinePass dots;
    dots.lineWidthPx = widthPx;
    dots.dashPx = {static_cast<float>(ui::tracedDots[0] * widthPx), static_cast<float>(ui::tracedDots[1] * widthPx)};
    LinePass shade = dots;
    shade.widthExtraPx = shade.fadePx = tracedShadePx;
    shade.opacityGain = tracedShadeOpacity;
    shade.shade = palette(ThemeMode::Dark).canvas;
    tracedShade.show(shade, content, placement);
    tracedDots.show(dots, content, placement);
}

VtkOverlay::VtkOverlay() : parts_(std::make_unique<Parts>())
{
    Parts& p = *parts_;
    p.renderer->GetCullers()->RemoveAllItems();
    p.renderer->AutomaticLightCreationOff();
    p.renderer->AddActor(p.frame.actor());
    for (LineLayer* layer : p.layers()) {
        p.renderer->AddActor(layer->actor());
    }
    p.renderer->AddActor2D(p.above.actor());
}

VtkOverlay::~VtkOverlay()
{
    if (parts_->window) {
        parts_->window->RemoveRenderer(parts_->renderer);
    }
}

void VtkOverlay::attachTo(vtkRenderWindow* window)
{
    parts_->window = window;
    window->AddRenderer(parts_->renderer);
}

void VtkOverlay::show(const OverlayScene& scene, bool isMirrored, const StrokeMesh& above)
{
    Parts& p = *parts_;
    const OverlayContent& content = scene.content();
    const int* size = p.window->GetSize();
    const ImagePlacement placement{content.viewRect, size[0], size[1], isMirrored};
    setPinhole(*p.renderer->GetActiveCamera(), usableCamera(content.camera), content.cameraFromPatient,
               placement.displayedRect());
    p.frame.show(content, placement);
    p.updateLines(content);
    for (LineLayer* layer : p.layers()) {
        layer->actor()->VisibilityOff();
    }
    const bool hasCamera = !core::findProblem(content.camera);
    if (hasCamera && content.mode != OverlayMode::Hidden && !content.isOverlayHidden) {
        p.showTree(content, placement);
    }
    if (content.isTracedShown && !content.isOverlayHidden) {
        p.showTraced(content, placement);
    }
    p.above.show(above);
    p.aboveVertices = above.vertexCount();
}

VtkOverlay::RenderStats VtkOverlay::renderStats() const
{
    RenderStats renderStats{4 + parts_->aboveVertices, parts_->aboveVertices > 0 ? 2U : 1U};
    const auto add = [&renderStats](LineLayer& layer, LineData& data) {
        if (layer.actor()->GetVisibility()) {
            renderStats.vertices += static_cast<std::size_t>(data.polyData()->GetNumberOfPoints());
            ++renderStats.drawCalls;
        }
    };
    add(parts_->inside, parts_->tree);
    add(parts_->glow, parts_->glowing);
    add(parts_->halo, parts_->tree);
    add(parts_->core, parts_->tree);
    add(parts_->tracedShade, parts_->traced);
    add(parts_->tracedDots, parts_->traced);
    return renderStats;
}

}   // namespace angiopose::ui
