#pragma once

#include "ui/scenes/canvas.h"
#include "ui/scenes/vtk_overlay.h"

#include <memory>

namespace angiopose::ui {

/// Renders an overlay scene with VTK to pixels, in its own OpenGL context. Use on the UI thread only. No window owns
/// the context, so a view that moves between windows keeps it.
class GlOverlay {
public:
    GlOverlay();
    ~GlOverlay();
    GlOverlay(const GlOverlay&) = delete;
    GlOverlay& operator=(const GlOverlay&) = delete;

    bool isReady() const;   ///< false without OpenGL 3.2

    /// Fills the canvas with the scene's view rectangle.
    void draw(const OverlayScene& scene, bool isMirrored, const StrokeMesh& above, Canvas canvas);
    VtkOverlay::Work work() const;   ///< of the last rendering

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::ui
