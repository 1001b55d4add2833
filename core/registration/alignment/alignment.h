#pragma once

#include "core/registration/alignment/reverse_matching.h"
#include "core/registration/pose/damped_descent.h"
#include "core/registration/pose/start_prior.h"

#include <algorithm>

namespace angiopose::core {

/// What a look at one pose gives.
struct Agreement {
    NormalEquations equations;   ///< of Σ w r² for steps about the pose, weights frozen
    double loss = 0.0;   ///< Σ 2ℓ² v (1 − w); a point that leaves or turns across costs the maximum
    std::vector<double> branchWeight;   ///< mean weight of each branch's points, 0…1
};

/// One point's share of the equations; weight 0 where nothing is near.
struct ResidualRow {
    Eigen::Vector3d fromCentroid = Eigen::Vector3d::Zero();   ///< mm, camera axes
    Vector6d gradient = Vector6d::Zero();   ///< for steps (rad, mm)
    Eigen::Vector3d cameraGradient = Eigen::Vector3d::Zero();   ///< for an error of the camera, see CameraError
    double residual = 0.0;   ///< px across the vessel, to the same side all along a branch
    double weight = 0.0;
    int branchIndex = 0;
};

/// Point-to-line agreement of the projected tree with the target (ALGORITHMS §6.2, 6.3, 6.5): Welsch weight of the
/// distance, cos⁴ gate of the directions, squared visibility of the branch.
class Alignment {
public:
    Alignment(std::vector<AlignmentPoint> points, const ProjectionCamera& camera, const TargetLines& target);

    Agreement look(const CentroidPose& pose, double scalePx) const;

    /// The same into an agreement that is reused: nothing is allocated after the first time.
    void look(const CentroidPose& pose, double scalePx, Agreement& agreement) const;

    /// Likewise, and the other way round besides (ALGORITHMS §6.6 b): every line of the target is drawn to the branch
    /// that runs nearest beside it, so that all of the image counts, not only what is nearest to some tree point.
    void searchBothDirections(const CentroidPose& pose, double scalePx, Agreement& agreement);

    /// The loss alone.
    double loss(const CentroidPose& pose, double scalePx) const;

    /// What `look` sums up, point by point.
    void collectRows(const CentroidPose& pose, double scalePx, std::vector<ResidualRow>& rows) const;

    /// The branches' mean weights become their visibility (§6.7).
    void setVisibility(const Agreement& agreement) { visibility_ = agreement.branchWeight; }
    void resetVisibility() { std::fill(visibility_.begin(), visibility_.end(), 1.0); }

    /// How well each point agrees with the target at a scale, 0…1, whatever its branch's visibility; NaN outside the
    /// image.
    void collectAgreement(const CentroidPose& pose, double scalePx, std::vector<double>& agreement) const;

    /// Residual across the line (px) of every point; NaN where no line is within `limitPx` in a like direction.
    void collectResiduals(const CentroidPose& pose, double limitPx, std::vector<double>& residuals) const;

    /// Median distance to the nearest line point, px; infinite when most points do not project.
    double medianDistancePx(const CentroidPose& pose, std::vector<double>& scratch) const;

    std::size_t size() const { return points_.size(); }
    double spreadMm() const { return spreadMm_; }   ///< rms distance of the points from the centroid

    /// What a refinement writes to, made once: its steps allocate nothing.
    struct Buffers {
        LookPair<Agreement> looks;
        std::vector<double> residuals;
        ReverseMatching reverse;
    };
    Buffers& buffers() { return buffers_; }

private:
    struct Match;
    bool match(const AlignmentPoint& point, const CentroidPose& pose, double limitPx, SeenPoint& seen,
               Match& match) const;
    Eigen::Vector3d cameraGradient(const SeenPoint& seen, const Match& found) const;
    template <class Matched>
    void addForward(double scalePx, const Matched& matched, Agreement& agreement) const;
    void addReverse(double scalePx, Agreement& agreement) const;

    std::vector<AlignmentPoint> points_;
    ProjectionCamera camera_;
    const TargetLines* target_;
    std::vector<double> visibility_;   ///< per branch, 0…1
    std::vector<double> pointCount_;   ///< per branch, at least 1
    double spreadMm_ = 0.0;
    Buffers buffers_;
};

/// The last scale of a refinement is this many standard deviations of the residuals (ALGORITHMS §6.5).
inline constexpr double scalePerNoise = 1.5;

/// Variance of the residuals that a scale stands for: what the prior is weighed with.
inline double noiseVariance(double scalePx)
{
    return scalePx * scalePx / (scalePerNoise * scalePerNoise);
}

}   // namespace angiopose::core
