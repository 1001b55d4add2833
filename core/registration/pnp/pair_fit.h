#pragma once

#include "core/geometry/projection_camera.h"
#include "core/registration/pose/start_prior.h"

#include <span>

namespace angiopose::core {

/// A place of the tree and the pixel where it is seen.
struct PlacePair {
    Eigen::Vector3d place;   ///< mm from the centroid, patient axes
    Eigen::Vector2d pixel;
};

/// Least squares of the pairs' distances, counted in mm at the centroid's depth, each with this standard deviation, by
/// so many Gauss–Newton steps; `prior` holds what the pairs leave open, and its locks.
CentroidPose fitPairs(std::span<const PlacePair> pairs, const ProjectionCamera& camera, const StartPrior& prior,
                      double pairStdMm, int steps, const CentroidPose& from);

}   // namespace angiopose::core
