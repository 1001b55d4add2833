#pragma once

#include "core/registration/matching/bin_grid.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

struct MixtureOptions {
    double scalePx = 15.0;   ///< σ of the positions
    double orientation = 0.3;   ///< σ of the unit directions
    double selfWeight = 1.0;
};

/// L2 distance between two Gaussian mixtures over position and direction, one for the projected tree P and one for the
/// traced vessels Q, up to the constant ⟨Q,Q⟩ (ALGORITHMS §3.12). Opposite directions count as equal.
class OrientedMixtureMetric {
public:
    /// Subsamples tree and target to the resolution of the scale.
    OrientedMixtureMetric(const RegistrationProblem& problem, const MixtureOptions& options);

    /// Returns w⟨P,P⟩ − 2⟨P,Q⟩ and its gradient for steps (rad, mm) about the pose, including the directions.
    double distance(const CentroidPose& pose, Vector6d& gradient);

private:
    struct Sample {
        Eigen::Vector3d fromCentroid;   ///< offset from the centroid, mm, patient axes
        Eigen::Vector3d tangent;   ///< unit vector
    };
    /// Projected sample; derivatives of a cost with respect to position and direction are propagated back through it.
    struct Projected {
        Eigen::Vector3d inCamera;
        Eigen::Vector3d tangent;   ///< camera axes
        double directionLength = 0.0;   ///< length of the image direction before normalization
    };
    /// Kernel between two oriented points: its value, and half its derivatives with respect to the first point.
    struct PairTerm {
        double value = 0.0;
        Eigen::Vector2d positionGradient = Eigen::Vector2d::Zero();
        Eigen::Vector2d directionGradient = Eigen::Vector2d::Zero();
    };
    void project(const CentroidPose& pose);
    PairTerm compare(const Eigen::Vector2d& position, const Eigen::Vector2d& direction,
                     const Eigen::Vector2d& otherPosition, const Eigen::Vector2d& otherDirection) const;
    void backpropagate(std::size_t sample, const Eigen::Vector2d& positionGradient,
                       const Eigen::Vector2d& directionGradient, const CentroidPose& pose, Vector6d& gradient) const;

    MixtureOptions options_;
    ProjectionCamera camera_;
    double reachPx_;   ///< kernel cutoff
    std::vector<Sample> samples_;
    std::vector<Projected> projected_;   ///< projected samples in front of the source
    std::vector<Eigen::Vector2d> positions_;   ///< positions of the projected samples
    std::vector<Eigen::Vector2d> directions_;   ///< unit directions of the projected samples
    std::vector<Eigen::Vector2d> targetPositions_;
    std::vector<Eigen::Vector2d> targetDirections_;
    BinGrid targetGrid_;
    BinGrid selfGrid_;
};

}   // namespace angiopose::core
