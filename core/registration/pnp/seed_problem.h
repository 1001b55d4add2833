#pragma once

#include "core/registration/pnp/kernel_pnp.h"
#include "core/registration/problem/progress_log.h"
#include "core/registration/problem/registration_problem.h"

#include <memory>
#include <string_view>
#include <vector>

namespace angiopose::core {

/// Input of point-matching methods. The points are in the frame of the initial camera, and the pose is the motion
/// cameraFromStart, initially the identity: only in this frame does rad² + mm² in the prior have the same meaning as in
/// DynaWeightPnP (ALGORITHMS §1, "perturbation models").
struct SeedProblem {
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector3d> auxiliary;   ///< points {p'} selected by option `auxiliary`
    PosePrior prior;   ///< prior of the full problem, from the preset
    KernelSchedule schedule;   ///< schedule of the full problem
    double minDepthMm = 0.0;   ///< minimum depth in all solves without a prior
    double maxDepthMm = 0.0;
    std::unique_ptr<PointIndex> target;   ///< index type selected by option `index`
    std::unique_ptr<NeighborSearch> search;   ///< null if only the nearest target points count
    Neighbors neighbors = Neighbors::Closest;
    SourceFreedom freedom;

    /// Returns the problem of all points with matches updated at every evaluation.
    KernelProblem full(const ProjectionCamera& camera) const
    {
        return {points, camera, target.get(), {}, search.get(), neighbors, freedom};
    }
};

SeedProblem makeSeedProblem(const RegistrationProblem& problem, const RegistrationOptions& options);

/// Whether {p'} can determine a pose: at least four points with a spread of at least 30 % of the tree's (ALGORITHMS
/// §3.2).
bool determinesPose(const std::vector<Eigen::Vector3d>& auxiliary, const std::vector<Eigen::Vector3d>& points);

}   // namespace angiopose::core
