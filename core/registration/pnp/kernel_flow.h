#pragma once

#include "core/registration/matching/bin_grid.h"
#include "core/registration/pnp/power_series.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/problem/registration_problem.h"

#include <cstdint>

namespace angiopose::core {

struct FlowOptions {
    double scalePx = 20.0;   ///< kernel width ℓ
    bool directions = true;   ///< whether to weight pairs by the similarity of their directions
};

/// Inner product of projected tree and traced vessels as functions on the image plane (ALGORITHMS §3.16): F = Σ_ij c_ij
/// exp(−‖u_i − q_j‖²/2ℓ²) / n, over the pairs within reach.
class KernelFlow {
public:
    /// Subsamples tree and target to the resolution of the scale.
    KernelFlow(const RegistrationProblem& problem, const FlowOptions& options);

    struct ValueAndGradient {
        double value = 0.0;   ///< F
        Vector6d gradient = Vector6d::Zero();   ///< with respect to pose steps (rad, mm), for fixed labels c_ij
    };
    ValueAndGradient at(const CentroidPose& pose);

    /// Returns F along a step from the pose of the last call of `at`, as a series in the fraction of the step, for the
    /// same pairs and labels.
    PowerSeries along(const Vector6d& step) const;

private:
    struct Sample {
        Eigen::Vector3d fromCentroid;   ///< offset from the centroid, mm, patient axes
        Eigen::Vector3d tangent;   ///< unit vector
    };
    /// Projection of a sample in front of the source.
    struct ProjectedSample {
        Eigen::Vector3d arm;   ///< offset from the centroid, camera axes
        Eigen::Vector3d inCamera;
        Eigen::Vector2d pixel;
        Eigen::Vector2d direction;   ///< unit vector; zero if seen end-on
    };
    struct Pair {
        std::int32_t seen, target;
        double label;   ///< direction similarity c_ij
    };
    void projectSamples(const CentroidPose& pose);
    double labelOf(const ProjectedSample& seen, std::size_t target) const;

    FlowOptions options_;
    ProjectionCamera camera_;
    std::vector<Sample> samples_;
    std::vector<Eigen::Vector2d> positions_;   ///< target point positions
    std::vector<Eigen::Vector2d> directions_;   ///< target directions, unit vectors
    BinGrid grid_;
    std::vector<ProjectedSample> projectedSamples_;
    std::vector<Pair> pairs_;
};

}   // namespace angiopose::core
