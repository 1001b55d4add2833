#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Smooths a skeleton path into a curve with points about 1 px apart.
Curve2d smoothCurve(const std::vector<Eigen::Vector2d>& pathPx, int id);

/// Moves the path with subpixel accuracy to the middle between both vessel walls (half depth of the profile across it
/// in `opacity`, averaged along the curve), smooths it, takes the radius from the same walls, and cuts off what extends
/// beyond the ends of the vessel. `maxRadiusPx` limits the profile.
Curve2d centeredCurve(const std::vector<Eigen::Vector2d>& pathPx, int id, const ImageF& opacity, double maxRadiusPx);

}   // namespace angiopose::core