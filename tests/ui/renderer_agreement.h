#pragma once

#include "ui/scenes/canvas.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/views/gl_overlay.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace angiopose::test {

/// One way of displaying one simulated case.
struct OverlayState {
    std::string name;
    std::function<void(ui::OverlayScene&)> apply;   ///< applies the state to the scene
};

/// Poses, modes, marks, colors, tints and cutouts of the case with this seed; eight of them.
std::vector<OverlayState> overlayStates(std::uint64_t seed);

/// Difference between the images of two renderers.
struct Agreement {
    double lineShiftPx = 0.0;   ///< maximum across the lines, device px
    int grayDifference = 0;   ///< maximum over all channels, excluding the edges of the overlay
    double edgeShare = 0.0;   ///< share of the image's pixels excluded as edges
    std::size_t lineSamples = 0;
    Eigen::Vector2d worstLineAt = Eigen::Vector2d::Zero();   ///< device px from the top left corner
    Eigen::Vector2i worstGrayAt = Eigen::Vector2i::Zero();
};

/// Draws the state with both renderers in an image `sizePx` wide and high; `scale` is that of the display. `disturb`
/// alters the scene for the OpenGL renderer only.
Agreement agreementOf(const OverlayState& state, ui::GlOverlay& gl, int sizePx, double scale,
                      const std::function<void(ui::OverlayScene&)>& disturb = {});

}   // namespace angiopose::test
