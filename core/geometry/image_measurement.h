#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose::core {

enum class MeasurementKind { Length, Angle, Area };

/// Where what is measured in an image is taken to lie; pixels: nowhere, they stay pixels; typed: where a pixel measures
/// what somebody typed.
enum class MeasurementPlane { Vessels, Detector, Pixels, Typed };

/// Something measured in one frame of an image: a line along its points, the angle at the second of three, or the area
/// inside a closed outline. Its value follows from camera and pose, see measureImage.
struct ImageMeasurement {
    MeasurementKind kind = MeasurementKind::Length;
    MeasurementPlane plane = MeasurementPlane::Vessels;
    std::vector<Eigen::Vector2d> pixels;
    int frame = 0;
    std::string name;   ///< for people; may be empty
    std::string extraKeys{};   ///< JSON object with what a case file says of it that this version does not know

    bool operator==(const ImageMeasurement&) const = default;
};

}   // namespace angiopose::core
