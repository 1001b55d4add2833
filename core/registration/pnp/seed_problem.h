#pragma once

#include "core/registration/pnp/kernel_pnp.h"
#include "core/registration/problem/progress_log.h"
#include "core/registration/problem/registration_problem.h"

#include <memory>
#include <string_view>
#include <vector>

namespace angiopose::core {

/// What the methods that match points start from. Points live in the start camera's frame and the pose is the motion
/// cameraFromStart, identity at first: only there do the rad² + mm² of the prior mean what they mean in the seed
/// (ALGORITHMS §1, "perturbation models").
struct SeedProblem {
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector3d> auxiliary;   ///< {p'}, by option `auxiliary`
    PosePrior prior;   ///< of the full problem, by preset
    KernelSchedule schedule;   ///< of the full problem
    double nearestMm = 0.0;   ///< the depth guard, for all that runs without a prior
    double farthestMm = 0.0;
    std::unique_ptr<PointIndex> target;   ///< by option `index`
    std::unique_ptr<NeighborSearch> search;   ///< null when only the nearest points count
    Neighbors neighbors = Neighbors::Closest;
    SourceFreedom freedom;

    /// All points, matched anew at every look.
    KernelProblem full(const ProjectionCamera& camera) const
    {
        return {points, camera, target.get(), {}, search.get(), neighbors, freedom};
    }
};

SeedProblem makeSeedProblem(const RegistrationProblem& problem, const RegistrationOptions& options);

/// Whether {p'} can fix a pose: at least four points, spread over 30 % of the tree's own spread (ALGORITHMS §3.2).
bool isSolvableAlone(const std::vector<Eigen::Vector3d>& auxiliary, const std::vector<Eigen::Vector3d>& points);

}   // namespace angiopose::core