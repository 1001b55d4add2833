#pragma once

#include "core/imaging/image2d.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Aylward's model-to-image metric (ALGORITHMS §3.4): centerlines lie on image ridges at the width of their vessel, and
/// wide vessels count more. The kernel is a Gaussian of the vessel's width minus one twice as wide, as in the authors'
/// later code: it does not respond to constant intensity, which keeps thin vessels from scoring on top of wide ones.
class VesselBrightness {
public:
    /// Uses only every third tree point if there are many.
    explicit VesselBrightness(const RegistrationProblem& problem);

    /// Returns the weighted mean ridge intensity along the projected tree, with vessel widths scaled by `widthScale`;
    /// points outside the image count as 0.
    double meanAt(const CentroidPose& pose, double widthScale) const;

    /// Returns half the negative gradient of `of` for steps (rad, mm) about the pose, using only the brightness change
    /// across each vessel; the matrix is the bias matrix that compensates for the frequency of directions.
    NormalEquations normalEquations(const CentroidPose& pose, double widthScale) const;

private:
    struct Point {
        Eigen::Vector3d fromCentroid;   ///< offset from the centroid, mm, patient axes
        Eigen::Vector3d tangent;   ///< unit vector
        double radiusMm = 0.0;
        double weight = 0.0;
    };
    /// Position of a vessel width between two pyramid levels.
    struct Level {
        std::size_t finer = 0;
        double share = 0.0;   ///< interpolation weight of the coarser level
    };
    Level levelOf(const Eigen::Vector3d& pointInCamera, double radiusMm) const;
    double brightnessAt(const Eigen::Vector2d& pixel, const Level& level) const;
    Eigen::Vector2d gradientAt(const Eigen::Vector2d& pixel, const Level& level) const;

    ProjectionCamera camera_;
    std::vector<Point> points_;
    double weightSum_ = 0.0;
    std::vector<ImageF> levels_;   ///< ridge responses at successively doubled widths, finest first
};

}   // namespace angiopose::core
