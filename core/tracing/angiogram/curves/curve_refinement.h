#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// A skeleton path as a smooth curve with points about 1 px apart.
Curve2d smoothCurve(const std::vector<Eigen::Vector2d>& pathPx, int id);

/// The path moved sub-pixel to the middle between both vessel walls (half of the depth of the profile across it in
/// `opacity`, averaged along the curve), smoothed, with the radius from the same walls, and without what runs on beyond
/// the ends of the vessel. `maxRadiusPx` bounds the profile.
Curve2d centerdCurve(const std::vector<Eigen::Vector2d>& pathPx, int id, const ImageF& opacity, double maxRadiusPx);

}   // namespace angiopose::core