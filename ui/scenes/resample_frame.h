#pragma once

#include "core/imaging/image2d.h"
#include "ui/scenes/canvas.h"
#include "ui/scenes/view_rect.h"

#include <cstdint>

namespace angiopose::ui {

/// Smooth blends between pixels; Nearest shows every pixel as it is.
enum class Interpolation { Smooth, Nearest };

/// Fills the canvas with the part `rect` of a grey picture, `around` where the picture ends. Smooth is linear when it
/// magnifies; when it shrinks, every source pixel counts (a tent as wide as a canvas pixel), so nothing flickers.
void resampleFrame(const core::Image2d<std::uint8_t>& gray, const ViewRect& rect, Interpolation interpolation,
                   const Color& around, Canvas canvas);

}   // namespace angiopose::ui