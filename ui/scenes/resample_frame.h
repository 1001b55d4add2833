#pragma once

#include "core/imaging/image2d.h"
#include "ui/scenes/canvas.h"
#include "ui/scenes/view_rect.h"

#include <cstdint>

namespace angiopose::ui {

/// `Smooth` interpolates between pixels; `Nearest` shows each pixel as a square.
enum class Interpolation { Smooth, Nearest };

/// Draws the part `rect` of a gray image over the whole canvas, with `around` as the color outside the image. `Smooth`
/// interpolates linearly when magnifying; when minifying, every source pixel contributes (tent filter as wide as a
/// canvas pixel), which avoids flicker.
void resampleFrame(const core::Image2d<std::uint8_t>& gray, const ViewRect& rect, Interpolation interpolation,
                   const Color& background, Canvas canvas);

}   // namespace angiopose::ui
