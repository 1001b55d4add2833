#pragma once

#include "core/geometry/rigid_transform.h"

namespace angiopose::core {

/// Difference between two poses of the vessels, about a pivot (the tree's centroid).
struct PoseDifference {
    double inPlaneMm = 0.0;   ///< shift of the pivot perpendicular to the camera axis
    double depthMm = 0.0;   ///< signed shift of the pivot along the camera axis; positive if `b` is farther away
    double rotationDeg = 0.0;   ///< total rotation angle, 0…180
};

PoseDifference differenceBetween(const RigidTransform& a, const RigidTransform& b,
                                 const Eigen::Vector3d& pivotInPatient);

}   // namespace angiopose::core
