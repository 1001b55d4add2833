#pragma once

#include "core/geometry/landmark.h"
#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace angiopose::core {

/// Minimum number of pairs that determine a pose without a previous pose.
inline constexpr std::size_t minLandmarks = 4;

/// Pose that aligns landmarks with their image points, and its accuracy.
struct LandmarkPose {
    RigidTransform cameraFromPatient;
    std::vector<double> errorPx;   ///< residual of each pair, in input order
    double rmsPx = 0.0;
    double depthStdMm = 0.0;   ///< 1-σ along the ray for click errors of clickStdPx
    double rotationStdDeg = 0.0;   ///< 1-σ about the least certain camera axis, for the same click errors
    bool usesPrior = false;   ///< whether undetermined parameters keep their previous values, for lack of pairs
};

/// Returns the distance between each landmark's projection and its pixel; infinite behind the source.
std::vector<double> landmarkErrorsPx(std::span<const Landmark> landmarks, const ProjectionCamera& camera,
                                     const RigidTransform& cameraFromPatient);

/// Returns the least-squares pose of four or more pairs: SQPNP (Terzakis & Lourakis, ECCV 2020), followed by damped
/// Gauss–Newton on the pixels, also from `before` if given; of two equally good poses, the one closer to `before`. One
/// to three pairs require `before`: they shift it, then roll and scale it, then rotate it as little as necessary. Fails
/// with a user message if the pairs do not determine a pose: too few, all in one place or on one line.
Result<LandmarkPose> poseFromLandmarks(std::span<const Landmark> landmarks, const ProjectionCamera& camera,
                                       const std::optional<RigidTransform>& knownPose);

}   // namespace angiopose::core
