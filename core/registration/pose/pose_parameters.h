#pragma once

#include "core/registration/pose/centroid_pose.h"

namespace core {

/// Six numbers about a pose, each worth about the same to the image: rotation vector about the tree's centroid, then
/// shift, both divided by their unit.
class PoseParameters {
public:
    PoseParameters(const CentroidPose& origin, const Vector6d& unit) : origin_(origin), unit_(unit) {}

    CentroidPose pose(const Vector6d& x) const { return moved(origin_, x.cwiseProduct(unit_)); }

    /// Gradient for x from the gradient for further steps (rad, mm) about pose(x).
    Vector6d gradient(const Vector6d& x, const Vector6d& stepGradient) const;

    const CentroidPose& origin() const { return origin_; }

private:
    CentroidPose origin_;
    Vector6d unit_;   ///< rad, mm
};

/// Units of `spreadMm` per radian and of 1 mm per mm: x is in mm of motion.
Vector6d metricUnits(double spreadMm);

/// Units from degrees about x and y, about z, mm across the ray and along it.
Vector6d clinicalUnits(double tiltDeg, double rollDeg, double lateralMm, double depthMm);

}   // namespace core
