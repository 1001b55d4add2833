#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Whether a dark path (pixel by pixel, px) is one side of an edge or line of the mask image that has moved:
/// subtraction leaves it twice, dark and bright side by side, with the bright side at least as strong. Contrast agent
/// never leaves anything brighter than the background, which is 0 in `opacity`; so neither vessels nor the background
/// between two of them are mistaken for a moved edge.
bool isMovedEdge(const std::vector<Eigen::Vector2d>& pathPx, const ImageF& opacity);

}   // namespace angiopose::core