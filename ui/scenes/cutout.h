#pragma once

#include "ui/scenes/canvas.h"
#include "ui/scenes/row_bands.h"
#include "ui/scenes/view_rect.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace angiopose::ui {

/// Region of the image where the overlay is hidden, for comparison with the plain angiogram.
struct Cutout {
    enum class Shape { None, RightOf, Disc };   ///< `RightOf` is the swipe, `Disc` the lens
    Shape shape = Shape::None;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();   ///< edge of the swipe or center of the lens, image px
    double radiusPx = 0.0;   ///< radius of the lens, image px

    bool operator==(const Cutout&) const = default;
};

/// In the given rows, replaces the pixels inside the cutout with those of `background` and draws the edge of the
/// cutout; `rect` is the part of the image that the canvas shows.
void applyCutout(const Cutout& cutout, const ViewRect& rect, const std::vector<std::uint32_t>& background,
                 Canvas canvas, const Rows& rows);

}   // namespace angiopose::ui
