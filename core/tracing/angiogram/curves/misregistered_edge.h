#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Returns whether a dark path (pixel by pixel, px) is a misregistration artifact of the subtraction: an edge or line
/// that moved between mask and frame appears twice, dark and bright side by side, with the bright side at least as
/// strong. Contrast agent never appears brighter than the background (0 in `opacity`), so neither vessels nor the
/// background between two vessels are mistaken for such an artifact.
bool isMisregisteredEdge(const std::vector<Eigen::Vector2d>& pathPx, const ImageF& opacity);

}   // namespace angiopose::core
