#pragma once

#include "core/geometry/rigid_transform.h"

#include <gtest/gtest.h>
#include <numbers>
#include <string>

namespace angiopose::test {

inline bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// Whether two poses agree within an angle and, at the given pivot (patient frame), within a distance.
inline ::testing::AssertionResult nearPose(const core::RigidTransform& actual, const core::RigidTransform& expected,
                                           double toleranceDeg, double toleranceMm,
                                           const Eigen::Vector3d& pivot = Eigen::Vector3d::Zero())
{
    const double angleDeg = core::angleBetween(actual.rotation, expected.rotation) * 180.0 / std::numbers::pi;
    const double distanceMm = (actual * pivot - expected * pivot).norm();
    if (angleDeg <= toleranceDeg && distanceMm <= toleranceMm) {
        return ::testing::AssertionSuccess();
    }
    return ::testing::AssertionFailure() << "poses differ by " << angleDeg << " deg and " << distanceMm << " mm";
}

}   // namespace angiopose::test
