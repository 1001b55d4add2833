#pragma once

#include "ui/scenes/overlay_scene.h"
#include "ui/scenes/stroke_mesh.h"

#include <memory>

class vtkRenderWindow;

namespace angiopose::ui {

/// Draws the angiogram and its overlay with VTK and OpenGL: the frame as a texture, the tree in space through a camera
/// at the X-ray source. A new pose, zoom or brightness changes only the camera and a few uniforms; points and pixels
/// are uploaded when they change. Matches the painter's output (tests/ui/views/renderers_agree_test.cpp).
class VtkOverlay {
public:
    VtkOverlay();
    ~VtkOverlay();
    VtkOverlay(const VtkOverlay&) = delete;
    VtkOverlay& operator=(const VtkOverlay&) = delete;

    void attachTo(vtkRenderWindow* window);   ///< call this once; `window` must outlive this object

    /// Sets the content of the next image; `above` holds strokes drawn on top, device px, y up.
    void show(const OverlayScene& scene, bool isMirrored = false, const StrokeMesh& above = {});

    /// OpenGL workload of the displayed image.
    struct RenderStats {
        std::size_t vertices = 0;
        std::size_t drawCalls = 0;
    };
    RenderStats renderStats() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::ui
