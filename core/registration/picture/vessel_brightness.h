#pragma once

#include "core/imaging/image2d.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Aylward's model-to-image metric (ALGORITHMS §3.4): centerlines lie on ridges of the image at each vessel's own
/// width; wide vessels count more. As in the later code of the source, the kernel does not respond to constant
/// brightness: a Gaussian of the vessel's width minus one twice as wide, which keeps thin vessels from gaining on top
/// of wide ones.
class VesselBrightness {
public:
    /// Uses every third tree point if there are many.
    explicit VesselBrightness(const RegistrationProblem& problem);

    /// Weighted mean ridge brightness under the tree, with widths scaled by `widening`; points outside the image count
    /// as dark.
    double of(const CentroidPose& pose, double widening) const;

    /// Half the negative gradient of `of` for steps (rad, mm) about the pose, using only the brightness change across
    /// each vessel; the matrix is the bias matrix that compensates for the frequency of directions.
    NormalEquations pull(const CentroidPose& pose, double widening) const;

private:
    struct Point {
        Eigen::Vector3d fromCentroid;   ///< mm, patient axes
        Eigen::Vector3d tangent;   ///< unit vector
        double radiusMm = 0.0;
        double weight = 0.0;
    };
    /// Position of a width between two levels.
    struct Level {
        std::size_t finer = 0;
        double share = 0.0;   ///< share of the coarser level
    };
    Level levelOf(const Eigen::Vector3d& pointInCamera, double radiusMm) const;
    double brightnessAt(const Eigen::Vector2d& pixel, const Level& level) const;
    Eigen::Vector2d gradientAt(const Eigen::Vector2d& pixel, const Level& level) const;

    ProjectionCamera camera_;
    std::vector<Point> points_;
    double weightSum_ = 0.0;
    std::vector<ImageF> levels_;   ///< ridges at doubling widths, finest first
};

}   // namespace angiopose::core