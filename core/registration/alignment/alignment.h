#pragma once

#include "core/registration/alignment/reverse_matching.h"
#include "core/registration/pose/damped_descent.h"
#include "core/registration/pose/initial_pose_prior.h"

#include <algorithm>

namespace angiopose::core {

/// Evaluation of the alignment at one pose.
struct AlignmentEvaluation {
    NormalEquations equations;   ///< normal equations of Σ w r² for steps about the pose, with the weights frozen
    double loss = 0.0;   ///< Σ 2ℓ² v (1 − w); points outside the image or crossing their line cost the maximum
    std::vector<double> branchWeight;   ///< mean weight of each branch's points, 0…1
};

/// Contribution of one point to the normal equations; weight 0 where no line is near.
struct ResidualRow {
    Eigen::Vector3d fromCentroid = Eigen::Vector3d::Zero();   ///< offset from the centroid in camera axes, mm
    Vector6d gradient = Vector6d::Zero();   ///< derivative of the residual with respect to the pose step (rad, mm)
    Eigen::Vector3d cameraGradient = Eigen::Vector3d::Zero();   ///< with respect to the camera error, see CameraError
    double residual = 0.0;   ///< px across the vessel, signed consistently along a branch
    double weight = 0.0;
    int branchIndex = 0;
};

/// Point-to-line agreement of the projected tree with the target (ALGORITHMS §6.2, 6.3, 6.5): Welsch weight of the
/// distance, cos⁴ gate of the directions, squared visibility of the branch.
class Alignment {
public:
    Alignment(std::vector<AlignmentPoint> points, const ProjectionCamera& camera, const TargetLines& target);

    AlignmentEvaluation evaluate(const CentroidPose& pose, double scalePx) const;

    /// Overload that reuses the buffers of `agreement` and does not allocate after the first call.
    void evaluate(const CentroidPose& pose, double scalePx, AlignmentEvaluation& agreement) const;

    /// Like evaluate, but also matches target lines to the tree (ALGORITHMS §6.6 b): every target line attracts the
    /// nearest branch, so that the whole image counts instead of only the lines nearest to a tree point.
    void searchBothDirections(const CentroidPose& pose, double scalePx, AlignmentEvaluation& agreement);

    /// Returns the loss only, without building the normal equations.
    double loss(const CentroidPose& pose, double scalePx) const;

    /// Collects the contribution of each point to the normal equations.
    void collectRows(const CentroidPose& pose, double scalePx, std::vector<ResidualRow>& rows) const;

    /// Sets the visibility of each branch to its mean weight (§6.7).
    void setVisibility(const AlignmentEvaluation& agreement) { visibility_ = agreement.branchWeight; }
    void resetVisibility() { std::fill(visibility_.begin(), visibility_.end(), 1.0); }

    /// Collects the agreement of each point with the target at the given scale, 0…1, regardless of branch visibility;
    /// NaN outside the image.
    void collectAgreement(const CentroidPose& pose, double scalePx, std::vector<double>& agreement) const;

    /// Collects the residual of each point across its line, px; NaN without a line of similar direction in `limitPx`.
    void collectResiduals(const CentroidPose& pose, double limitPx, std::vector<double>& residuals) const;

    /// Returns the median distance to the nearest line point, px; infinite if most points do not project.
    double medianDistancePx(const CentroidPose& pose, std::vector<double>& scratch) const;

    std::size_t size() const { return points_.size(); }
    double spreadMm() const { return spreadMm_; }   ///< RMS distance of the points from the centroid

    /// Buffers of a refinement, allocated once so that its steps need not allocate.
    struct Buffers {
        EvaluationPair<AlignmentEvaluation> evaluations;
        std::vector<double> residuals;
        ReverseMatcher reverse;
    };
    Buffers& buffers() { return buffers_; }

private:
    struct Match;
    bool match(const AlignmentPoint& point, const CentroidPose& pose, double limitPx, PointInCamera& projected,
               Match& match) const;
    Eigen::Vector3d cameraGradient(const PointInCamera& projected, const Match& found) const;
    template <class Matched>
    void addForwardMatches(double scalePx, const Matched& matched, AlignmentEvaluation& agreement) const;
    void addReverseMatches(double scalePx, AlignmentEvaluation& agreement) const;

    std::vector<AlignmentPoint> points_;
    ProjectionCamera camera_;
    const TargetLines* target_;
    std::vector<double> visibility_;   ///< visibility of each branch, 0…1
    std::vector<double> pointCount_;   ///< number of points of each branch, at least 1
    double spreadMm_ = 0.0;
    Buffers buffers_;
};

/// Final scale of a refinement in standard deviations of the residuals (ALGORITHMS §6.5).
inline constexpr double scalePerNoise = 1.5;

/// Returns the residual variance implied by a Welsch scale; used to weight the prior against the data.
inline double noiseVariance(double scalePx)
{
    return scalePx * scalePx / (scalePerNoise * scalePerNoise);
}

}   // namespace angiopose::core
