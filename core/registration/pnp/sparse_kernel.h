#pragma once

#include "core/registration/matching/feature_map.h"
#include "core/registration/pnp/kernel_distances.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Kernel agreement of a few tree points with the target, fast enough to evaluate for thousands of poses.
class SparseKernel {
public:
    SparseKernel(const RegistrationProblem& problem, std::size_t maxPoints);

    /// Returns the mean of exp(−d²/2ℓ²), 0…1.
    double agreement(const CentroidPose& pose, double scalePx);

    /// Returns the pose after one Gauss–Newton step on the kernel-weighted squares; with `inPlaneOnly` the out-of-plane
    /// rotations are fixed.
    CentroidPose gaussNewtonStep(const CentroidPose& pose, double scalePx, bool inPlaneOnly);

private:
    KernelProblem problem() const { return {points_, camera_, &target_, {}}; }

    ProjectionCamera camera_;
    PoseFreedom freedom_;
    std::vector<Eigen::Vector3d> points_;   ///< relative to the centroid, where a centroid pose is a rigid motion
    FeatureMap target_;
    KernelDistances distances_;
};

}   // namespace angiopose::core
