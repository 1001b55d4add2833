#pragma once

#include "core/registration/pnp/branch_matching.h"

#include <functional>

namespace angiopose::core {

/// Nonrigid motion of the points of a tree.
struct PairDeformation {
    std::vector<Eigen::Vector3d> motionMm;   ///< motion of each tree point, patient axes
    double rmsMm = 0.0;   ///< RMS of all motions
    double maxMotionMm = 0.0;
    double medianBeforePx = 0.0;   ///< median distance of the pairs at the rigid pose
    double medianPx = 0.0;   ///< median distance of the pairs after the motion
};

/// Maximum number of evaluations of deformOntoPairs, which moves the tree points toward fixed matches as far as lengths
/// and neighbors allow (ALGORITHMS §3.9). Minimizes Σ ‖π(p + φ) − q‖² + α Σ (‖(p_a + φ_a) − (p_b + φ_b)‖ − ‖p_a −
/// p_b‖)² + β Σ ‖φ_a − φ_b‖² over the links of the tree by L-BFGS, at a fixed pose. Calls `isStopped` after each
/// evaluation.
inline constexpr int deformationEvaluations = 300;
PairDeformation deformOntoPairs(const RegistrationProblem& problem, const BranchGraph& tree, const CentroidPose& pose,
                                const std::vector<BranchPair>& pairs, const std::function<bool()>& isStopped);

}   // namespace angiopose::core
