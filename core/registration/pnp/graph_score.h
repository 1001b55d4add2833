#pragma once

#include "core/registration/matching/feature_map.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/problem/registration_problem.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Score for ranking the hypotheses of graph matching (ALGORITHMS §3.17): closeness of the tree to the traced vessels,
/// minus a penalty that keeps the tree from collapsing onto a few vessels.
class GraphScore {
public:
    static constexpr double scalePx = 5.0;   ///< distance at which a point still scores 0.37

    /// `spreadWeight` is the weight λ of the penalty against collapse.
    GraphScore(const RegistrationProblem& problem, double spreadWeight);

    /// Returns the score of a pose, at most 1; minus infinity if no point projects.
    double scoreAt(const CentroidPose& pose) const;

private:
    ProjectionCamera camera_;
    double spreadWeight_;
    FeatureMap target_;
    double targetSpreadPx_;
    std::vector<Eigen::Vector3d> probes_;   ///< sampled tree points, mm relative to the centroid
};

}   // namespace angiopose::core
