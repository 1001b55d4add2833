#pragma once

#include "core/geometry/projection_camera.h"
#include "core/registration/pose/initial_pose_prior.h"

#include <span>

namespace angiopose::core {

/// Point of the tree and the pixel where it is observed.
struct PointPixelPair {
    Eigen::Vector3d position;   ///< offset from the centroid, mm, patient axes
    Eigen::Vector2d pixel;
};

/// Fits a pose to the pairs by least squares of their distances in mm at the centroid's depth, each with the same
/// standard deviation, in a given number of Gauss–Newton steps; `prior` constrains what the pairs leave undetermined
/// and contains the locks.
CentroidPose fitPairs(std::span<const PointPixelPair> pairs, const ProjectionCamera& camera,
                      const InitialPosePrior& prior, double pairStdMm, int steps, const CentroidPose& from);

}   // namespace angiopose::core
