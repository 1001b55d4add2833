#pragma once

#include "ui/scenes/canvas.h"
#include "ui/scenes/vtk_overlay.h"

#include <memory>

namespace angiopose::ui {

/// Renders an overlay scene to pixels with VTK. Use it on the GUI thread only. The OpenGL context belongs to this
/// object and not to a window, so it remains valid when a view moves to another window.
class GlOverlay {
public:
    GlOverlay();
    ~GlOverlay();
    GlOverlay(const GlOverlay&) = delete;
    GlOverlay& operator=(const GlOverlay&) = delete;

    bool isReady() const;   ///< false without OpenGL 3.2

    /// Draws the view rectangle of the scene over the whole canvas.
    void draw(const OverlayScene& scene, bool isMirrored, const StrokeMesh& above, Canvas canvas);
    VtkOverlay::RenderStats renderStats() const;   ///< OpenGL workload of the last rendering

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::ui
