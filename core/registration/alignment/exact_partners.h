#pragma once

#include "core/registration/pose/centroid_pose.h"
#include "core/registration/registration_problem.h"

#include <optional>

namespace core {

/// Point-to-point refinement for data whose target points are projections of the tree's own points, as in simulations.
/// The data decide: nothing unless the nearest target points lie far closer than the target's spacing, and closer still
/// after refining. With real partners the pose is then exact (ALGORITHMS §7, "exact-sample").
std::optional<CentroidPose> refineWithExactPartners(const RegistrationProblem& problem, const CentroidPose& pose);

}   // namespace core
