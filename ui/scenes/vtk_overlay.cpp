#include "ui/scenes/vtk_overlay.h"

#include "ui/scenes/line_layer.h"
#include "ui/scenes/overlay_lines.h"
#include "ui/scenes/overlay_pens.h"
#include "ui/scenes/shader_actor.h"
#include "ui/scenes/stroke_actor.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCullerCollection.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkUniforms.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace angiopose::ui {
namespace {

/// Gray image as an OpenGL texture, uploaded only when the image changes.
class GrayTexture {
public:
    GrayTexture();
    void show(const core::Image2d<std::uint8_t>& picture, std::uint64_t revision);
    bool shows(std::uint64_t revision) const { return shownRevision_ == revision; }
    vtkTexture* texture() { return texture_; }

private:
    vtkNew<vtkImageData> data_;
    vtkNew<vtkTexture> texture_;
    std::uint64_t shownRevision_ = 0;
};

/// Layer that shows the angiogram over the whole viewport, with the DRR tint and the edge of the cutout.
class FrameLayer : public ShaderActor {
public:
    FrameLayer();
    void show(const OverlayContent& content, const ImagePlacement& placement);

private:
    void showGray(const OverlayContent& content);
    void showTint(const OverlayContent& content);

    GrayTexture frame_;
    GrayTexture drr_;
};

/// Returns a rectangle that covers the viewport, in normalized device coordinates.
vtkSmartPointer<vtkPolyData> wholeImage()
{
    vtkNew<vtkPoints> points;
    for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
        points->InsertNextPoint(x, y, 0.0);
    }
    vtkNew<vtkCellArray> cells;
    const vtkIdType corners[] = {0, 1, 2, 3};
    cells->InsertNextCell(4, corners);
    auto rectangle = vtkSmartPointer<vtkPolyData>::New();
    rectangle->SetPoints(points);
    rectangle->SetPolys(cells);
    return rectangle;
}

core::Image2d<std::uint8_t> bytesOf(const core::ImageF& shares)
{
    core::Image2d<std::uint8_t> bytes(shares.width, shares.height);
    std::ranges::transform(shares.pixels, bytes.pixels.begin(),
                           [](float share) { return static_cast<std::uint8_t>(std::lround(255.0F * share)); });
    return bytes;
}

GrayTexture::GrayTexture()
{
    texture_->SetColorModeToDirectScalars();
    texture_->InterpolateOff();
    texture_->MipmapOff();
    texture_->RepeatOff();
    texture_->SetInputData(data_);
}

void GrayTexture::show(const core::Image2d<std::uint8_t>& picture, std::uint64_t revision)
{
    shownRevision_ = revision;
    const bool isEmpty = picture.pixels.empty();
    data_->SetDimensions(isEmpty ? 1 : picture.width, isEmpty ? 1 : picture.height, 1);
    data_->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    auto* texel = static_cast<std::uint8_t*>(data_->GetScalarPointer());
    *texel = 0;
    std::ranges::copy(picture.pixels, texel);
    data_->Modified();
}

FrameLayer::FrameLayer() : ShaderActor(wholeImage(), frameShaders())
{
    actor()->GetProperty()->SetTexture("frame", frame_.texture());
    actor()->GetProperty()->SetTexture("radiograph", drr_.texture());
}

void FrameLayer::show(const OverlayContent& content, const ImagePlacement& placement)
{
    if (!frame_.shows(content.frame.revision())) {
        frame_.show(content.frame.gray(), content.frame.revision());
    }
    if (!drr_.shows(content.drr.revision())) {
        drr_.show(bytesOf(content.drr.share()), content.drr.revision());
    }
    setPlacementUniforms(content.cutout, placement);
    const ViewRect part = placement.displayedRect();
    const std::array<float, 4> edges{static_cast<float>(part.left), static_cast<float>(part.right),
                                     static_cast<float>(part.top), static_cast<float>(part.bottom)};
    fragmentUniforms().SetUniform4f("part", edges.data());
    showGray(content);
    showTint(content);
}

void FrameLayer::showGray(const OverlayContent& content)
{
    const GrayFrame& frame = content.frame;
    const std::array<float, 2> size{static_cast<float>(frame.width()), static_cast<float>(frame.height())};
    vtkUniforms& uniforms = fragmentUniforms();
    uniforms.SetUniform2f("frameSize", size.data());
    uniforms.SetUniformi("isSmooth", content.interpolation == Interpolation::Smooth ? 1 : 0);
}

void FrameLayer::showTint(const OverlayContent& content)
{
    const Palette& colors = palette(ThemeMode::Dark);
    const bool isShown = !content.drr.isEmpty() && !content.isOverlayHidden;
    vtkUniforms& uniforms = fragmentUniforms();
    uniforms.SetUniformf("tintDepth", isShown ? static_cast<float>(maxTintOpacity * content.opacity) : 0.0F);
    uniforms.SetUniform3f("tintTone", floatColor(branchColors(colors).auxiliary).data());
    uniforms.SetUniform3f("around", floatColor(colors.canvas).data());
    uniforms.SetUniform3f("edgeTone", floatColor(colors.label).data());
}

/// Places a VTK camera at the X-ray source: a point in patient space (mm) appears at the pixel given by
/// `core::project`, and so that the part `rect` of the image fills the view.
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

    // Half extent of the view at depth 1, and offset of its center from the central ray in half extents; fx > 0 in
    // mirrored images.
    const double halfWidth = 0.5 * rect.width();
    const double halfHeight = 0.5 * rect.height();
    view.SetViewAngle(2.0 * std::atan(halfHeight / camera.fy) * 180.0 / std::numbers::pi);
    view.UseExplicitAspectRatioOn();
    view.SetExplicitAspectRatio((halfWidth / camera.fx) / (halfHeight / camera.fy));
    view.SetWindowCenter((0.5 * (rect.left + rect.right) - camera.cx) / halfWidth,
                         (camera.cy - 0.5 * (rect.top + rect.bottom)) / halfHeight);
}

/// Returns a camera for the traced curves if none is known: any camera works, because the curves lie on the image.
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
