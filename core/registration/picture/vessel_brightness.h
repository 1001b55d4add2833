#pragma once

#include "core/imaging/image2d.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Aylward's model-to-image metric (ALGORITHMS §3.4): centrelines lie on ridges of the image at each vessel's own
/// width, wide vessels count more. As in the later code of the source the kernel does not answer to flat brightness: a
/// Gaussian of the width less one twice as wide, so that thin vessels gain nothing on top of wide ones.
class VesselBrightness {
public:
    /// Uses every third tree point where they are many.
    explicit VesselBrightness(const RegistrationProblem& problem);

    /// Weighted mean ridge brightness under the tree, widths times `widening`; points off the image count as dark.
    double of(const CentroidPose& pose, double widening) const;

    /// Half the negative gradient of `of` for steps (rad, mm) about the pose, brightness moving points only across
    /// their vessel; the matrix is the bias matrix that evens out how often directions occur.
    NormalEquations pull(const CentroidPose& pose, double widening) const;

private:
    struct Point {
        Eigen::Vector3d fromCentroid;   ///< mm, patient axes
        Eigen::Vector3d tangent;   ///< unit
        double radiusMm = 0.0;
        double weight = 0.0;
    };
    /// Where a width lies between the levels.
    struct Level {
        std::size_t finer = 0;
        double share = 0.0;   ///< of the coarser
    };
    Level levelOf(const Eigen::Vector3d& pointInCamera, double radiusMm) const;
    double brightnessAt(const Eigen::Vector2d& pixel, const Level& level) const;
    Eigen::Vector2d gradientAt(const Eigen::Vector2d& pixel, const Level& level) const;

    ProjectionCamera camera_;
    std::vector<Point> points_;
    double weightSum_ = 0.0;
    std::vector<ImageF> levels_;   ///< ridges of doubling width, finest first
};

}   // namespace angiopose::core