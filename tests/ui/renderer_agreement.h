#pragma once

#include "ui/scenes/canvas.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/views/gl_overlay.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace angiopose::test {

/// One way to show one simulated case.
struct OverlayState {
    std::string name;
    std::function<void(ui::OverlayScene&)> apply;   ///< after which the scene shows it
};

/// Poses, modes, marks, colours, tints and cutouts of the case with this seed; eight of them.
std::vector<OverlayState> overlayStates(std::uint64_t seed);

/// How far the pictures of two renderers are apart.
struct Agreement {
    double lineShiftPx = 0.0;   ///< worst, across the lines; device px
    int grayDifference = 0;   ///< worst of any channel, outside of the overlay's edges
    double edgeShare = 0.0;   ///< of the picture's pixels: they were left out
    std::size_t lineSamples = 0;
    Eigen::Vector2d worstLineAt = Eigen::Vector2d::Zero();   ///< device px from the top left
    Eigen::Vector2i worstGrayAt = Eigen::Vector2i::Zero();
};

/// Draws the state by both renderers in a picture `sizePx` wide and high; `scale` is the display's. What `disturb` does
/// to the scene, the painter does not see.
Agreement agreementOf(const OverlayState& state, ui::GlOverlay& gl, int sizePx, double scale,
                      const std::function<void(ui::OverlayScene&)>& disturb = {});

}   // namespace angiopose::test
