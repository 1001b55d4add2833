#pragma once

#include "core/registration/matching/bin_grid.h"
#include "core/registration/pnp/power_series.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/problem/registration_problem.h"

#include <cstdint>

namespace angiopose::core {

struct FlowOptions {
    double scalePx = 20.0;   ///< ℓ
    bool directions = true;   ///< weight pairs by the similarity of their directions
};

/// Inner product of projected tree and traced vessels as functions on the image plane (ALGORITHMS §3.16): F = Σ_ij c_ij
/// exp(−‖u_i − q_j‖²/2ℓ²) / n, over the pairs within reach.
class KernelFlow {
public:
    /// Thins the samples to the resolution of the scale.
    KernelFlow(const RegistrationProblem& problem, const FlowOptions& options);

    struct Slope {
        double value = 0.0;   ///< F
        Vector6d gradient = Vector6d::Zero();   ///< for steps (rad, mm) about the pose, with the labels c_ij fixed
    };
    Slope at(const CentroidPose& pose);

    /// F along a step from the pose of the last call of `at`, as a function of the fraction of the step; uses the same
    /// pairs and labels.
    PowerSeries along(const Vector6d& step) const;

private:
    struct Sample {
        Eigen::Vector3d fromCentroid;   ///< mm, patient axes
        Eigen::Vector3d tangent;   ///< unit vector
    };
    /// Sample that projects.
    struct Seen {
        Eigen::Vector3d arm;   ///< offset from the centroid, camera axes
        Eigen::Vector3d inCamera;
        Eigen::Vector2d pixel;
        Eigen::Vector2d direction;   ///< unit vector; zero: seen end-on
    };
    struct Pair {
        std::int32_t seen, target;
        double label;   ///< c_ij
    };
    void look(const CentroidPose& pose);
    double labelOf(const Seen& seen, std::size_t target) const;

    FlowOptions options_;
    ProjectionCamera camera_;
    std::vector<Sample> samples_;
    std::vector<Eigen::Vector2d> places_;   ///< target points
    std::vector<Eigen::Vector2d> directions_;   ///< target directions, unit vectors
    BinGrid grid_;
    std::vector<Seen> seen_;
    std::vector<Pair> pairs_;
};

}   // namespace angiopose::core
