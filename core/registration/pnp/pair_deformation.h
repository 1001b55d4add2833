#pragma once

#include "core/registration/pnp/branch_matching.h"

#include <functional>

namespace angiopose::core {

/// Where the points of a tree go when they may leave their rigid places.
struct PairDeformation {
    std::vector<Eigen::Vector3d> motionMm;   ///< of each tree point, patient axes
    double rmsMm = 0.0;   ///< of all motions
    double largestMm = 0.0;
    double medianBeforePx = 0.0;   ///< of the pairs, rigid
    double medianPx = 0.0;   ///< the same after the motion
};

/// Moves the points of the tree towards held partners, so far as lengths and neighbours let them (ALGORITHMS §3.9):
/// Σ ‖π(p + φ) − q‖² + α Σ (‖(p_a + φ_a) − (p_b + φ_b)‖ − ‖p_a − p_b‖)² + β Σ ‖φ_a − φ_b‖² over the links of the tree,
/// by L-BFGS. The pose stays. `isStopped` is asked after each of the evaluations, `deformationEvaluations` at most.
inline constexpr int deformationEvaluations = 300;
PairDeformation deformOntoPairs(const RegistrationProblem& problem, const BranchGraph& tree, const CentroidPose& pose,
                                const std::vector<BranchPair>& pairs, const std::function<bool()>& isStopped);

}   // namespace angiopose::core
