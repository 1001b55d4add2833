#include "ui/scenes/line_layer.h"

#include <vtkDataObject.h>
#include <vtkUniforms.h>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {

LineLayer::LineLayer(LineData& data) : ShaderActor(data.polyData(), lineShaders())
{
    for (const char* name : LineData::attributes()) {
        mapper().MapDataArrayToVertexAttribute(name, name, vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
    }
}

void LineLayer::show(const LinePass& pass, const OverlayContent& content, const ImagePlacement& placement)
{
    actor()->VisibilityOn();
    setPlacementUniforms(content.cutout, placement);
    setPenUniforms(pass);
    showDepth(pass);
    const std::array<float, 2> size{static_cast<float>(placement.width), static_cast<float>(placement.height)};
    vertexUniforms().SetUniform2f("viewport", size.data());
    vertexUniforms().SetUniformf("handed", placement.isMirrored ? -1.0F : 1.0F);
    vertexUniforms().SetUniformf("radiusScale", static_cast<float>(std::abs(content.camera.fx) * placement.scale()));
    geometryUniforms().SetUniform2f("viewport", size.data());
    geometryUniforms().SetUniformf("wayScale", static_cast<float>(placement.scale()));
    fragmentUniforms().SetUniformf("opacity", static_cast<float>(pass.opacity));
}

void LineLayer::setPenUniforms(const LinePass& pass)
{
    vtkUniforms& pen = geometryUniforms();
    pen.SetUniformi("mode", static_cast<int>(pass.shape));
    pen.SetUniformi("showsDots", pass.hasEndDots ? 1 : 0);
    pen.SetUniformf("lineWidthPx", static_cast<float>(pass.lineWidthPx));
    pen.SetUniformf("widthGain", static_cast<float>(pass.widthGain));
    pen.SetUniformf("widthExtraPx", static_cast<float>(pass.widthExtraPx));
    pen.SetUniformf("fadePx", static_cast<float>(pass.fadePx));
    pen.SetUniformf("fadeGain", static_cast<float>(pass.fadeGain));
    pen.SetUniformf("opacityGain", static_cast<float>(pass.opacityGain));
    const std::array<float, 3> tone = floatColor(pass.shade.value_or(Color{}));
    const std::array<float, 4> shade{tone[0], tone[1], tone[2], pass.shade ? 1.0F : 0.0F};
    pen.SetUniform4f("shade", shade.data());
    pen.SetUniform2f("dashPx", pass.dashPx.data());
}

void LineLayer::showDepth(const LinePass& pass)
{
    const Palette& colors = palette(ThemeMode::Dark);
    const DepthRange range = pass.depth.value_or(DepthRange{});
    const double spanMm = pass.depth ? std::max(1.0, range.farMm - range.nearMm) : 0.0;
    vertexUniforms().SetUniformf("nearMm", static_cast<float>(range.nearMm));
    vertexUniforms().SetUniformf("spanMm", static_cast<float>(spanMm));
    vertexUniforms().SetUniform3f("nearTone", floatColor(colors.textStrong).data());
    vertexUniforms().SetUniform3f("farTone", floatColor(colors.canvas).data());
}

}   // namespace angiopose::ui
