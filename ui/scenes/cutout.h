#pragma once

#include "ui/scenes/canvas.h"
#include "ui/scenes/row_bands.h"
#include "ui/scenes/view_rect.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace angiopose::ui {

/// Region without overlay, for comparison with the plain angiogram.
struct Cutout {
    enum class Shape { None, RightOf, Disc };   ///< RightOf: swipe, Disc: lens
    Shape shape = Shape::None;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();   ///< image px: edge of the swipe or center of the lens
    double radiusPx = 0.0;   ///< radius of the lens, image px

    bool operator==(const Cutout&) const = default;
};

/// Restores the plain pixels inside the cutout and draws its edge, in these rows; `rect` is the image part shown by the
/// canvas.
void applyCutout(const Cutout& cutout, const ViewRect& rect, const std::vector<std::uint32_t>& bare, Canvas canvas,
                 const Rows& rows);

}   // namespace angiopose::ui