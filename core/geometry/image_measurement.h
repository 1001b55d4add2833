#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose::core {

enum class MeasurementKind { Length, Angle, Area };

/// Plane in which a measurement in an image is assumed to lie. `Pixels`: no plane, lengths stay in pixels; `Typed`: the
/// plane for which the user entered the pixel size.
enum class MeasurementPlane { Vessels, Detector, Pixels, Typed };

/// A measurement in one frame of an image: the length of a line through its points, the angle at the second of three
/// points, or the area inside a closed outline. Its value follows from camera and pose (see measureImage).
struct ImageMeasurement {
    MeasurementKind kind = MeasurementKind::Length;
    MeasurementPlane plane = MeasurementPlane::Vessels;
    std::vector<Eigen::Vector2d> pixels;
    int frame = 0;
    std::string name;   ///< display name; may be empty
    std::string extraKeys{};   ///< JSON object with the case-file keys that this version does not recognize

    bool operator==(const ImageMeasurement&) const = default;
};

}   // namespace angiopose::core
