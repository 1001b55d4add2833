#pragma once

#include "core/registration/matching/target_lines.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// How far apart two poses put the tree, seen along the rays: mean over its points of the shift across the camera's z,
/// mm. About the reprojection distance of ALGORITHMS §4.5, blind to depth like it.
double meanShiftMm(const TreeSamples& tree, const RigidTransform& a, const RigidTransform& b);

/// The same to be expected from a covariance: root mean square over the tree's points, 1-σ. An error of the camera
/// moves tree and rays alike and does not count.
double expectedShiftMm(const RegistrationProblem& problem, const RigidTransform& pose,
                       const PoseUncertainty& uncertainty);

/// How far the tree's centroid is from where the start has it along the ray, mm; farther is positive.
double depthShiftMm(const RegistrationProblem& problem, const RigidTransform& cameraFromPatient);

/// How far the pose slides when it is refined where it is: large when the vessels fit better close by.
double settlingShiftMm(const RegistrationProblem& problem, const TargetLines& target, const RigidTransform& pose,
                       const RegistrationOptions& options);

}   // namespace angiopose::core