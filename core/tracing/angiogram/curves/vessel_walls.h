#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// The two walls of a vessel at one point of its curve, along the normal.
struct VesselWalls {
    double middlePx = 0.0;   ///< signed offset from the point
    double halfWidthPx = 0.0;
};

/// For each point, the walls where the profile across it, averaged over neighboring points, falls to half of its depth.
/// Nothing if it does not fall within `reachPx`, or if the walls jump relative to those around them because another
/// vessel joins there.
std::vector<std::optional<VesselWalls>> findWalls(const std::vector<Eigen::Vector2d>& points,
                                                  const std::vector<Eigen::Vector2d>& normals, const ImageF& opacity,
                                                  double reachPx);

}   // namespace angiopose::core