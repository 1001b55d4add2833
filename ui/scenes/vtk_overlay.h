#pragma once

#include "ui/scenes/overlay_scene.h"
#include "ui/scenes/stroke_mesh.h"

#include <memory>

class vtkRenderWindow;

namespace angiopose::ui {

/// Draws the angiogram with what lies on it by VTK and OpenGL: the frame as a texture, the tree in space through a
/// camera at the X-ray source. A new pose, zoom or brightness changes the camera and a few numbers; points and pixels
/// are sent when they change. The picture is the painter's (tests/ui/scenes/renderers_agree_test.cpp).
class VtkOverlay {
public:
    VtkOverlay();
    ~VtkOverlay();
    VtkOverlay(const VtkOverlay&) = delete;
    VtkOverlay& operator=(const VtkOverlay&) = delete;

    void attachTo(vtkRenderWindow* window);   ///< once; `window` outlives this

    /// What the next picture shows. `above`: strokes over everything, device px, y up.
    void show(const OverlayScene& scene, bool isMirrored = false, const StrokeMesh& above = {});

    /// What the shown picture hands to OpenGL.
    struct Work {
        std::size_t vertices = 0;
        std::size_t drawCalls = 0;
    };
    Work work() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::ui
