#pragma once

#include "ui/scenes/overlay_content.h"
#include "ui/scenes/overlay_shaders.h"
#include "ui/scenes/view_rect.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>

#include <array>

class vtkUniforms;

namespace angiopose::ui {

/// Visible part of the image and size of the view. `isMirrored` swaps left and right, as viewed from the X-ray source.
struct ImagePlacement {
    ViewRect rect;
    int width = 1;   ///< width of the view, device px
    int height = 1;
    bool isMirrored = false;

    double scale() const { return width / rect.width(); }   ///< device px per image px

    /// Returns the visible part with `left` and `right` at the left and right edges of the view.
    ViewRect displayedRect() const
    {
        return isMirrored ? ViewRect{rect.right, rect.left, rect.top, rect.bottom} : rect;
    }
};

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

    /// Sets the uniforms for cutout and view, which every fragment shader uses.
    void setPlacementUniforms(const Cutout& cutout, const ImagePlacement& placement);

private:
    vtkNew<vtkOpenGLPolyDataMapper> mapper_;
    vtkNew<vtkActor> actor_;
};

std::array<float, 3> floatColor(const Color& color);

}   // namespace angiopose::ui
