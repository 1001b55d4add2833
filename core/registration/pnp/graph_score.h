#pragma once

#include "core/registration/matching/feature_map.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/problem/registration_problem.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// How well a pose suits a traced image as graph matching ranks its hypotheses (ALGORITHMS §3.17): the nearer the tree
/// comes to the traced vessels the better, less what keeps it from collapsing upon few of them.
class GraphScore {
public:
    static constexpr double scalePx = 5.0;   ///< a point this far off counts 0.37

    /// `spreadWeight`: λ of what keeps the tree from collapsing.
    GraphScore(const RegistrationProblem& problem, double spreadWeight);

    /// At most 1; minus infinity where nothing projects.
    double of(const CentroidPose& pose) const;

private:
    ProjectionCamera camera_;
    double spreadWeight_;
    FeatureMap target_;
    double targetSpreadPx_;
    std::vector<Eigen::Vector3d> probes_;   ///< tree points, mm from the centroid
};

}   // namespace angiopose::core
