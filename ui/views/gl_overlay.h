#pragma once

#include "ui/scenes/canvas.h"
#include "ui/scenes/vtk_overlay.h"

#include <memory>

namespace angiopose::ui {

/// An overlay scene drawn by VTK into pixels, in an OpenGL context of its own. Belongs to the thread of the user
/// interface. A view that moves between windows keeps it: no window owns the context.
class GlOverlay {
public:
    GlOverlay();
    ~GlOverlay();
    GlOverlay(const GlOverlay&) = delete;
    GlOverlay& operator=(const GlOverlay&) = delete;

    bool isReady() const;   ///< false where there is no OpenGL 3.2

    /// Fills the canvas with what the scene's view rectangle shows.
    void draw(const OverlayScene& scene, bool isMirrored, const StrokeMesh& above, Canvas canvas);
    VtkOverlay::Work work() const;   ///< of the last picture

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::ui
