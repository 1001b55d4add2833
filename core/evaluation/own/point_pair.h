#pragma once

#include <Eigen/Core>

namespace angiopose::core {

/// A place that was pointed at in the patient and in the image.
struct PointPair {
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

}   // namespace angiopose::core
