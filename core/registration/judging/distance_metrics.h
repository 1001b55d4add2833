#pragma once

#include "core/registration/matching/grid_index.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Maximum distance at which a point counts as lying on a vessel, px.
inline constexpr double matchTolerancePx = 3.0;

/// Tree points projected at one pose. Distances refer to the curves, not to their sample points.
struct ProjectedTree {
    std::vector<Eigen::Vector2d> pointsPx;   ///< one per tree point; NaN where the point does not project
    std::vector<double> distancePx;   ///< distance to the target; the image diagonal where a point does not project
    std::vector<std::uint8_t> isInView;   ///< 1 if inside the image
};

/// Returns the projected tree points; `target` must index the points of problem.target.
ProjectedTree projectTree(const RegistrationProblem& problem, const RigidTransform& cameraFromPatient,
                          const GridIndex& target);

/// Returns the distances in both directions (ALGORITHMS §4.5). A point outside the image keeps its full distance.
DistanceMetrics distanceMetrics(const RegistrationProblem& problem, const RigidTransform& cameraFromPatient,
                                const ProjectedTree& projected);

/// Returns the residuals of each used branch, in the tree's order.
std::vector<BranchResidual> branchResiduals(const TreeSamples& tree, const ProjectedTree& projected);

}   // namespace angiopose::core
