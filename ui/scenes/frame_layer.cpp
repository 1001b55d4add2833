#include "ui/scenes/frame_layer.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkUniforms.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

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

}   // namespace

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

}   // namespace angiopose::ui
