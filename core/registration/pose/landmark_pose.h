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

/// Pairs that fix a pose without knowing one before.
inline constexpr std::size_t enoughLandmarks = 4;

/// The pose that lays landmarks onto their pixels, and how much it is to be believed.
struct LandmarkPose {
    RigidTransform cameraFromPatient;
    std::vector<double> errorPx;   ///< what remains of each pair, in the order given
    double rmsPx = 0.0;
    double depthStdMm = 0.0;   ///< 1-σ along the ray when each click is off by clickStdPx
    double rotationStdDeg = 0.0;   ///< the same about the worst axis
    bool leansOnPrior = false;   ///< too few pairs: what they leave open is as it was before
};

/// Distance between each landmark's projection and its pixel; infinite behind the source.
std::vector<double> landmarkErrorsPx(std::span<const Landmark> landmarks, const ProjectionCamera& camera,
                                     const RigidTransform& cameraFromPatient);

/// Least-squares pose of four pairs or more: SQPNP (Terzakis & Lourakis, ECCV 2020), then damped Gauss-Newton on the
/// pixels, also from `before` where there is one; of two equally good ones the nearer to `before`.
/// With one to three pairs `before` is needed: they shift it, then roll and scale it, then turn it as little as need
/// be. Fails in words for the user when the pairs fix no pose: too few, all in one place or on one line.
Result<LandmarkPose> poseFromLandmarks(std::span<const Landmark> landmarks, const ProjectionCamera& camera,
                                       const std::optional<RigidTransform>& before);

}   // namespace angiopose::core