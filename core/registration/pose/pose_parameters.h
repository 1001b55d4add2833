#pragma once

#include "core/registration/pose/pose_freedom.h"

#include <vector>

namespace angiopose::core {

/// The free coordinates of a pose (see PoseFreedom) counted from an origin and divided by their unit, so that each is
/// worth about the same to the image.
class PoseParameters {
public:
    /// `unit`: of the six coordinates, rad and mm; those that are locked drop out.
    PoseParameters(const CentroidPose& origin, const Vector6d& unit, const PoseFreedom& freedom);

    Eigen::Index count() const { return static_cast<Eigen::Index>(free_.size()); }
    Eigen::VectorXd origin() const { return Eigen::VectorXd::Zero(count()); }

    CentroidPose pose(const Eigen::VectorXd& x) const;

    /// Gradient for x from the gradient for further steps (rad, mm) about pose(x).
    Eigen::VectorXd gradient(const Eigen::VectorXd& x, const Vector6d& stepGradient) const;

private:
    PoseFreedom freedom_;
    Vector6d origin_;   ///< coordinates at x = 0
    Vector6d unit_;
    std::vector<Eigen::Index> free_;   ///< numbers of the free coordinates
};

/// Units of `spreadMm` per radian and of 1 mm per mm: x is in mm of motion.
Vector6d metricUnits(double spreadMm);

/// Units from degrees about x and y, about z, mm across the ray and along it.
Vector6d clinicalUnits(double tiltDeg, double rollDeg, double lateralMm, double depthMm);

}   // namespace angiopose::core