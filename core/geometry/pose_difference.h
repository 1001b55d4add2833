#pragma once

#include "core/geometry/rigid_transform.h"

namespace angiopose::core {

/// How far apart two poses put the vessels, about a pivot (the tree's centroid).
struct PoseDifference {
    double inPlaneMm = 0.0;   ///< of the pivot, across the camera axis
    double depthMm = 0.0;   ///< of the pivot, along the camera axis; signed, positive: `b` lies farther from the source
    double rotationDeg = 0.0;   ///< 0…180
};

PoseDifference differenceBetween(const RigidTransform& a, const RigidTransform& b,
                                 const Eigen::Vector3d& pivotInPatient);

}   // namespace angiopose::core