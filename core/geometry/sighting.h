#pragma once

#include <Eigen/Core>
#include <string>

namespace angiopose::core {

/// Where a check point of the vessels is seen in one frame of an image.
struct Sighting {
    int markId = 0;   ///< see VesselMark
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    int frame = 0;
    std::string extraKeys{};   ///< JSON object with what a case file says of it that this version does not know

    bool operator==(const Sighting&) const = default;
};

}   // namespace angiopose::core
