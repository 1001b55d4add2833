#pragma once

#include "core/geometry/image_measurement.h"
#include "core/imaging/volume_slice.h"

#include <string>
#include <vector>

namespace angiopose::core {

/// Something measured in one slice of a scan: a line along its points, the angle at the second of three, or the area
/// inside a closed outline. Its value follows from the points alone.
struct SliceMeasurement {
    MeasurementKind kind = MeasurementKind::Length;
    BodyPlane plane = BodyPlane::Axial;   ///< of the slice; all points lie in it
    std::vector<Eigen::Vector3d> pointsInPatient;   ///< LPS, mm
    std::string name;   ///< for people; may be empty
    std::string extraKeys{};   ///< JSON object with what a case file says of it that this version does not know

    bool operator==(const SliceMeasurement&) const = default;
};

}   // namespace angiopose::core
