#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Smooths a skeleton path to a curve with points about 1 px apart.
Curve2d smoothCurve(const std::vector<Eigen::Vector2d>& pathPx, int id);

/// Centers the path between the vessel walls with subpixel accuracy (half depth of the cross-profile in `opacity`,
/// averaged along the curve), smooths it, measures the radius between the same walls, and trims overshoot beyond the
/// vessel ends. `maxRadiusPx` limits the length of the profile.
Curve2d centerCurve(const std::vector<Eigen::Vector2d>& pathPx, int id, const ImageF& opacity, double maxRadiusPx);

}   // namespace angiopose::core
