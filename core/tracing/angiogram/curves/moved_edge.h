#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Whether a dark path (pixel by pixel, px) is one side of an edge or line of the mask image that moved: subtraction
/// leaves it twice, dark and bright, side by side, the bright side no weaker. Contrast medium leaves nothing brighter
/// than the background, which in `opacity` is 0; so neither vessels nor the ground between two of them are taken for
/// it.
bool isMovedEdge(const std::vector<Eigen::Vector2d>& pathPx, const ImageF& opacity);

}   // namespace angiopose::core