#pragma once

#include "core/geometry/projection_camera.h"
#include "core/registration/pose/start_prior.h"

#include <span>

namespace angiopose::core {

/// Point of the tree and the pixel where it is observed.
struct PlacePair {
    Eigen::Vector3d place;   ///< mm relative to the centroid, patient axes
    Eigen::Vector2d pixel;
};

/// Least-squares fit of the pairs' distances, measured in mm at the centroid's depth, each with this standard
/// deviation, by this number of Gauss–Newton steps; `prior` constrains what the pairs leave undetermined and holds the
/// locks.
CentroidPose fitPairs(std::span<const PlacePair> pairs, const ProjectionCamera& camera, const StartPrior& prior,
                      double pairStdMm, int steps, const CentroidPose& from);

}   // namespace angiopose::core
