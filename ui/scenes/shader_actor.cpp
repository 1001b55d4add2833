#include "ui/scenes/shader_actor.h"

#include <vtkPolyData.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

namespace angiopose::ui {

ShaderActor::ShaderActor(vtkPolyData* data, const ShaderSources& shaders)
{
    mapper_->SetInputData(data);
    mapper_->SetVBOShiftScaleMethod(0);   // keeps vertices in the coordinates in which the shaders read their neighbors
    mapper_->ScalarVisibilityOff();
    mapper_->StaticOn();
    actor_->SetMapper(mapper_);
    actor_->ForceOpaqueOn();   // draws actors in the order in which they were added; the shaders set the opacity
    actor_->PickableOff();
    actor_->UseBoundsOff();   // prevents culling of lines by their spatial bounds
    vtkShaderProperty* property = actor_->GetShaderProperty();
    property->SetVertexShaderCode(shaders.vertex.c_str());
    if (!shaders.geometry.empty()) {
        property->SetGeometryShaderCode(shaders.geometry.c_str());
    }
    property->SetFragmentShaderCode(shaders.fragment.c_str());
}

vtkUniforms& ShaderActor::vertexUniforms()
{
    return *actor_->GetShaderProperty()->GetVertexCustomUniforms();
}

vtkUniforms& ShaderActor::geometryUniforms()
{
    return *actor_->GetShaderProperty()->GetGeometryCustomUniforms();
}

vtkUniforms& ShaderActor::fragmentUniforms()
{
    return *actor_->GetShaderProperty()->GetFragmentCustomUniforms();
}

void ShaderActor::setPlacementUniforms(const Cutout& cutout, const ImagePlacement& placement)
{
    const double scale = placement.scale();
    const std::array<float, 4> where{
        static_cast<float>(cutout.shape), static_cast<float>((cutout.at.x() - placement.rect.left) * scale),
        static_cast<float>((cutout.at.y() - placement.rect.top) * placement.height / placement.rect.height()),
        static_cast<float>(cutout.radiusPx * scale)};
    const std::array<float, 2> size{static_cast<float>(placement.width), static_cast<float>(placement.height)};
    fragmentUniforms().SetUniform4f("cutout", where.data());
    fragmentUniforms().SetUniform2f("viewport", size.data());
    fragmentUniforms().SetUniformf("handed", placement.isMirrored ? -1.0F : 1.0F);
}

std::array<float, 3> floatColor(const Color& color)
{
    const std::array<double, 3> tone = color.unit();
    return {static_cast<float>(tone[0]), static_cast<float>(tone[1]), static_cast<float>(tone[2])};
}

}   // namespace angiopose::ui
