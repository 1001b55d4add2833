#pragma once

#include "core/registration/pose/pose_freedom.h"

#include <vector>

namespace angiopose::core {

/// Free coordinates of a pose (see PoseFreedom) relative to an origin, in units with about equal effects in the image.
class PoseParameters {
public:
    /// `unit` holds the units of all six coordinates (rad, mm); locked coordinates are not part of x.
    PoseParameters(const CentroidPose& origin, const Vector6d& unit, const PoseFreedom& freedom);

    Eigen::Index count() const { return static_cast<Eigen::Index>(free_.size()); }
    Eigen::VectorXd origin() const { return Eigen::VectorXd::Zero(count()); }

    CentroidPose pose(const Eigen::VectorXd& x) const;

    /// Converts a gradient for steps (rad, mm) about pose(x) to a gradient with respect to x.
    Eigen::VectorXd gradient(const Eigen::VectorXd& x, const Vector6d& stepGradient) const;

private:
    PoseFreedom freedom_;
    Vector6d origin_;   ///< coordinates at x = 0
    Vector6d unit_;
    std::vector<Eigen::Index> free_;   ///< indices of the free coordinates
};

/// Returns units for which x measures motion in mm: one radian counts as `spreadMm`, one mm as 1 mm.
Vector6d metricUnits(double spreadMm);

/// Returns units from a tilt about x and y, a roll about z, and shifts across and along the ray.
Vector6d clinicalUnits(double tiltDeg, double rollDeg, double lateralMm, double depthMm);

}   // namespace angiopose::core
