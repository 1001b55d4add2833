#pragma once

#include "core/registration/matching/grid_index.h"
#include "core/registration/problem/registration_problem.h"

#include <optional>

namespace angiopose::core {

/// Point-to-point refinement for data whose target points are projections of the tree's own points, as in simulations.
/// The data decide: nothing unless the nearest target points lie far closer than the target's spacing, and closer still
/// after refining. With real partners the pose is then exact (ALGORITHMS §7, "exact-sample").
class ExactPartners {
public:
    explicit ExactPartners(const RegistrationProblem& problem);

    /// Nothing when the points turn out not to be partners, or the pose is not yet near enough to tell.
    std::optional<CentroidPose> refine(const CentroidPose& pose);

private:
    /// A tree point in the camera and its way to the nearest target point.
    struct Pair {
        Eigen::Vector3d turned;   ///< from the centroid, camera axes
        Eigen::Vector3d inCamera;
        Eigen::Vector2d residualPx;
    };
    void match(const CentroidPose& pose);
    double medianPx();
    NormalEquations equations(double scalePx) const;

    ProjectionCamera camera_;
    PoseFreedom freedom_;
    GridIndex target_;
    double spacingPx_ = 0.0;   ///< of the target
    std::vector<Eigen::Vector3d> fromCentroid_;   ///< some tree points
    std::vector<Pair> pairs_;
    std::vector<double> distances_;
};

}   // namespace angiopose::core