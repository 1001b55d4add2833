#pragma once

#include "core/registration/pose/pose_freedom.h"

#include <vector>

namespace angiopose::core {

/// Free coordinates of a pose (see PoseFreedom), relative to an origin and scaled by units that give each about the
/// same effect in the image.
class PoseParameters {
public:
    /// `unit` holds the units of the six coordinates, rad and mm; locked ones are left out.
    PoseParameters(const CentroidPose& origin, const Vector6d& unit, const PoseFreedom& freedom);

    Eigen::Index count() const { return static_cast<Eigen::Index>(free_.size()); }
    Eigen::VectorXd origin() const { return Eigen::VectorXd::Zero(count()); }

    CentroidPose pose(const Eigen::VectorXd& x) const;

    /// Gradient with respect to x, from the gradient with respect to steps (rad, mm) about pose(x).
    Eigen::VectorXd gradient(const Eigen::VectorXd& x, const Vector6d& stepGradient) const;

private:
    PoseFreedom freedom_;
    Vector6d origin_;   ///< coordinates at x = 0
    Vector6d unit_;
    std::vector<Eigen::Index> free_;   ///< indices of the free coordinates
};

/// Units for which x is in mm of motion: `spreadMm` per radian and 1 mm per mm.
Vector6d metricUnits(double spreadMm);

/// Units given by degrees about x and y, degrees about z, mm across the ray and mm along it.
Vector6d clinicalUnits(double tiltDeg, double rollDeg, double lateralMm, double depthMm);

}   // namespace angiopose::core