#pragma once

#include "ui/scenes/canvas.h"
#include "ui/scenes/row_bands.h"
#include "ui/scenes/view_rect.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace angiopose::ui {

/// A part of the picture where the overlay steps aside, so that the angiogram can be compared with it.
struct Cutout {
    enum class Shape { None, RightOf, Disc };   ///< a swipe, a lens
    Shape shape = Shape::None;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();   ///< image px: the swipe's edge, the lens's centre
    double radiusPx = 0.0;   ///< of the lens, image px

    bool operator==(const Cutout&) const = default;
};

/// Puts the bare pixels back inside the cutout and draws its edge, in these rows; `rect` is what the canvas shows.
void applyCutout(const Cutout& cutout, const ViewRect& rect, const std::vector<std::uint32_t>& bare, Canvas canvas,
                 const Rows& rows);

}   // namespace angiopose::ui