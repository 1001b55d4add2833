#pragma once

#include "core/registration/matching/feature_map.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/problem/registration_problem.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Score by which graph matching ranks its hypotheses (ALGORITHMS §3.17): closeness of the tree to the traced vessels,
/// minus a penalty that keeps the tree from collapsing onto few of them.
class GraphScore {
public:
    static constexpr double scalePx = 5.0;   ///< distance at which a point counts 0.37

    /// `spreadWeight` is λ of the penalty against collapse.
    GraphScore(const RegistrationProblem& problem, double spreadWeight);

    /// At most 1; minus infinity if nothing projects.
    double of(const CentroidPose& pose) const;

private:
    ProjectionCamera camera_;
    double spreadWeight_;
    FeatureMap target_;
    double targetSpreadPx_;
    std::vector<Eigen::Vector3d> probes_;   ///< tree points, mm relative to the centroid
};

}   // namespace angiopose::core
