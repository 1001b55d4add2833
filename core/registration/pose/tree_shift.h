#pragma once

#include "core/geometry/rigid_transform.h"

#include <vector>

namespace angiopose::core {

/// Computes the motion of the whole tree between two poses from the mean and scatter of its points.
class TreeShift {
public:
    explicit TreeShift(const std::vector<Eigen::Vector3d>& pointsInPatient);

    /// Returns the root mean square distance between the points at the two poses.
    double rmsMm(const RigidTransform& a, const RigidTransform& b) const;

private:
    Eigen::Vector3d centroid_ = Eigen::Vector3d::Zero();
    Eigen::Matrix3d scatter_ = Eigen::Matrix3d::Zero();   ///< mm², covariance of the points
};

}   // namespace angiopose::core
