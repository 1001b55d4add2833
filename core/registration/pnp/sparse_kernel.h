#pragma once

#include "core/registration/matching/feature_map.h"
#include "core/registration/pnp/kernel_distances.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Kernel agreement of a few tree points with the target, quick enough to ask of thousands of poses.
class SparseKernel {
public:
    SparseKernel(const RegistrationProblem& problem, std::size_t most);

    /// Mean of exp(−d²/2ℓ²), 0…1.
    double agreement(const CentroidPose& pose, double scalePx);

    /// The pose after one Gauss–Newton step on the kernel-weighted squares; with `inPlaneOnly` the turns out of the
    /// image plane stay.
    CentroidPose stepped(const CentroidPose& pose, double scalePx, bool inPlaneOnly);

private:
    KernelProblem problem() const { return {points_, camera_, &target_, {}}; }

    ProjectionCamera camera_;
    PoseFreedom freedom_;
    std::vector<Eigen::Vector3d> points_;   ///< from the centroid: there a centroid pose is a rigid motion
    FeatureMap target_;
    KernelDistances distances_;
};

}   // namespace angiopose::core