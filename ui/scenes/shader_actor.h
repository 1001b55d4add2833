#pragma once

#include "ui/scenes/image_placement.h"
#include "ui/scenes/overlay_content.h"
#include "ui/scenes/overlay_shaders.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>

#include <array>

class vtkUniforms;

namespace angiopose::ui {

/// VTK actor that draws poly data with custom GLSL shaders.
class ShaderActor {
public:
    ShaderActor(vtkPolyData* data, const ShaderSources& shaders);
    vtkActor* actor() { return actor_; }

protected:
    vtkOpenGLPolyDataMapper& mapper() { return *mapper_; }
    vtkUniforms& vertexUniforms();
    vtkUniforms& geometryUniforms();
    vtkUniforms& fragmentUniforms();

    /// Sets the uniforms of cutout and view, which every fragment shader uses.
    void setPlacementUniforms(const Cutout& cutout, const ImagePlacement& placement);

private:
    vtkNew<vtkOpenGLPolyDataMapper> mapper_;
    vtkNew<vtkActor> actor_;
};

std::array<float, 3> floatColor(const Color& color);

}   // namespace angiopose::ui
