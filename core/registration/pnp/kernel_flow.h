#pragma once

#include "core/registration/matching/bin_grid.h"
#include "core/registration/pnp/power_series.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/problem/registration_problem.h"

#include <cstdint>

namespace angiopose::core {

struct FlowOptions {
    double scalePx = 20.0;   ///< ℓ
    bool directions = true;   ///< pairs count by how alike they run
};

/// Inner product of projected tree and traced vessels as functions of the image plane (ALGORITHMS §3.16):
/// F = Σ_ij c_ij exp(−‖u_i − q_j‖²/2ℓ²) / n, over the pairs within reach.
class KernelFlow {
public:
    /// Samples are thinned to what the scale can tell apart.
    KernelFlow(const RegistrationProblem& problem, const FlowOptions& options);

    struct Slope {
        double value = 0.0;   ///< F
        Vector6d gradient = Vector6d::Zero();   ///< for steps (rad, mm) about the pose, the labels c_ij held
    };
    Slope at(const CentroidPose& pose);

    /// F along a step from the pose that `at` was last asked of, in parts of the step; the same pairs and labels.
    PowerSeries along(const Vector6d& step) const;

private:
    struct Sample {
        Eigen::Vector3d fromCentroid;   ///< mm, patient axes
        Eigen::Vector3d tangent;   ///< unit
    };
    /// A sample that projects.
    struct Seen {
        Eigen::Vector3d arm;   ///< from the centroid, camera axes
        Eigen::Vector3d inCamera;
        Eigen::Vector2d pixel;
        Eigen::Vector2d direction;   ///< unit; zero: seen end-on
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
    std::vector<Eigen::Vector2d> places_;   ///< of the target
    std::vector<Eigen::Vector2d> directions_;   ///< of the target, unit
    BinGrid grid_;
    std::vector<Seen> seen_;
    std::vector<Pair> pairs_;
};

}   // namespace angiopose::core
