#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// The two walls of a vessel at one point of its curve, along the normal.
struct VesselWalls {
    double centerOffsetPx = 0.0;   ///< signed offset of the center from the point
    double halfWidthPx = 0.0;
};

/// Finds the walls at each point, where the cross-profile, averaged over neighboring points, falls to half of its
/// depth. An entry is nullopt if the profile does not fall within `reachPx`, or if the walls jump relative to their
/// neighbors because another vessel joins there.
std::vector<std::optional<VesselWalls>> findWalls(const std::vector<Eigen::Vector2d>& points,
                                                  const std::vector<Eigen::Vector2d>& normals, const ImageF& opacity,
                                                  double reachPx);

}   // namespace angiopose::core
