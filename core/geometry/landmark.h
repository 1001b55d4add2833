#pragma once

#include <Eigen/Core>
#include <string>

namespace angiopose::core {

/// A place that was pointed at twice: on the vessels and in the image.
struct Landmark {
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    std::string name;   ///< for people; may be empty
    std::string extraKeys{};   ///< JSON object with what a case file says of it that this version does not know

    bool operator==(const Landmark&) const = default;
};

}   // namespace angiopose::core