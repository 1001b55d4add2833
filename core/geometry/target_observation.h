#pragma once

#include <Eigen/Core>
#include <string>

namespace angiopose::core {

/// Image position of a target point of the vessels in one frame.
struct TargetObservation {
    int markId = 0;   ///< id of the target point, see VesselMark
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    int frame = 0;
    std::string extraKeys{};   ///< JSON object with the case-file keys that this version does not recognize

    bool operator==(const TargetObservation&) const = default;
};

}   // namespace angiopose::core
