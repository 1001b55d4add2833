#pragma once

#include "core/registration/matching/target_lines.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Displacement of the tree between two poses as seen along the rays: mean over its points of the shift perpendicular
/// to the camera's z axis, mm. Approximates the reprojection distance of ALGORITHMS §4.5 and, like it, ignores depth.
double meanShiftMm(const TreeSamples& tree, const RigidTransform& a, const RigidTransform& b);

/// Expected shift for a covariance: root mean square over the tree's points, 1-σ. Excludes camera errors, which move
/// tree and rays together.
double expectedShiftMm(const RegistrationProblem& problem, const RigidTransform& pose,
                       const PoseUncertainty& uncertainty);

/// Distance of the tree's centroid from its initial position along the ray, mm; positive is farther from the source.
double depthShiftMm(const RegistrationProblem& problem, const RigidTransform& cameraFromPatient);

/// Distance the pose slides when refined in place: large if the vessels fit better nearby.
double settlingShiftMm(const RegistrationProblem& problem, const TargetLines& target, const RigidTransform& pose,
                       const RegistrationOptions& options);

}   // namespace angiopose::core