#pragma once

#include "core/registration/matching/grid_index.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Distance that counts as "on the vessel".
inline constexpr double agreementPx = 3.0;

/// Projection of the tree points under one pose. Distances are to the curves, not to their sample points.
struct ProjectedTree {
    std::vector<Eigen::Vector2d> pointsPx;   ///< one per tree point; NaN where the point does not project
    std::vector<double> distancePx;   ///< distance to the target; the image diagonal where a point does not project
    std::vector<std::uint8_t> isInView;   ///< 1: inside the image
};

/// `target` indexes the points of problem.target.
ProjectedTree projectTree(const RegistrationProblem& problem, const RigidTransform& cameraFromPatient,
                          const GridIndex& target);

/// Distances in both directions of ALGORITHMS §4.5. A point that leaves the view keeps its full distance.
DistanceMetrics distanceMetrics(const RegistrationProblem& problem, const RigidTransform& cameraFromPatient,
                                const ProjectedTree& projected);

/// One entry per used branch, in the tree's order.
std::vector<BranchResidual> branchResiduals(const TreeSamples& tree, const ProjectedTree& projected);

}   // namespace angiopose::core