#pragma once

#include "core/geometry/rigid_transform.h"

#include <vector>

namespace angiopose::core {

/// How far a change of pose moves the tree: all its points at once, by their mean and their scatter.
class TreeShift {
public:
    explicit TreeShift(const std::vector<Eigen::Vector3d>& pointsInPatient);

    /// Root of the mean squared distance between where the two poses put the points.
    double rmsMm(const RigidTransform& a, const RigidTransform& b) const;

private:
    Eigen::Vector3d centroid_ = Eigen::Vector3d::Zero();
    Eigen::Matrix3d scatter_ = Eigen::Matrix3d::Zero();   ///< mm², covariance of the points
};

}   // namespace angiopose::core