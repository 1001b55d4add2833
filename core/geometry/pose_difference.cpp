#include "core/geometry/pose_difference.h"

#include <numbers>

namespace angiopose::core {

PoseDifference differenceBetween(const RigidTransform& a, const RigidTransform& b,
                                 const Eigen::Vector3d& pivotInPatient)
{
    const Eigen::Vector3d shift = b * pivotInPatient - a * pivotInPatient;
    return {shift.head<2>().norm(), shift.z(), angleBetween(a.rotation, b.rotation) * 180.0 / std::numbers::pi};
}

}   // namespace angiopose::core
