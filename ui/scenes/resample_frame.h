#pragma once

#include "core/imaging/image2d.h"
#include "ui/scenes/canvas.h"
#include "ui/scenes/view_rect.h"

#include <cstdint>

namespace angiopose::ui {

/// Smooth interpolates between pixels; Nearest shows individual pixels.
enum class Interpolation { Smooth, Nearest };

/// Fills the canvas with the part `rect` of a gray image, and with `around` outside it. Smooth is linear when
/// magnifying; when shrinking, every source pixel contributes (tent filter as wide as a canvas pixel), which avoids
/// flicker.
void resampleFrame(const core::Image2d<std::uint8_t>& gray, const ViewRect& rect, Interpolation interpolation,
                   const Color& around, Canvas canvas);

}   // namespace angiopose::ui