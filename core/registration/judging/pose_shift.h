#pragma once

#include "core/registration/matching/target_lines.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Returns the mean displacement of the tree points between two poses, perpendicular to the camera's z axis, mm.
/// Approximates the reprojection distance of ALGORITHMS §4.5 and, like that distance, ignores depth.
double meanShiftMm(const TreeSamples& tree, const RigidTransform& a, const RigidTransform& b);

/// Returns the expected in-plane displacement for a covariance: root mean square over the tree points, 1-σ. Excludes
/// camera errors, which displace tree and rays together.
double expectedShiftMm(const RegistrationProblem& problem, const RigidTransform& pose,
                       const PoseUncertainty& uncertainty);

/// Returns the change in depth of the tree's centroid from the initial pose, mm; positive is farther from the source.
double depthShiftMm(const RegistrationProblem& problem, const RigidTransform& cameraFromPatient);

/// Returns the distance by which the pose moves when refined in place; large if the vessels fit better nearby.
double refinementShiftMm(const RegistrationProblem& problem, const TargetLines& target, const RigidTransform& pose,
                         const RegistrationOptions& options);

}   // namespace angiopose::core
