#pragma once

#include <Eigen/Core>
#include <string>

namespace angiopose::core {

/// A point marked both on the vessels and in the image.
struct Landmark {
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    std::string name;   ///< display name; may be empty
    std::string extraKeys{};   ///< JSON object with the case-file keys that this version does not recognize

    bool operator==(const Landmark&) const = default;
};

}   // namespace angiopose::core
