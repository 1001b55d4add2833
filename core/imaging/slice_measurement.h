#pragma once

#include "core/geometry/image_measurement.h"
#include "core/imaging/volume_slice.h"

#include <string>
#include <vector>

namespace angiopose::core {

/// A measurement in one slice of a scan: the length of a line through its points, the angle at the second of three
/// points, or the area inside a closed outline. Its value depends only on the points.
struct SliceMeasurement {
    MeasurementKind kind = MeasurementKind::Length;
    BodyPlane plane = BodyPlane::Axial;   ///< plane of the slice; all points lie in it
    std::vector<Eigen::Vector3d> pointsInPatient;   ///< LPS, mm
    std::string name;   ///< display name; may be empty
    std::string extraKeys{};   ///< JSON object with the case-file keys that this version does not recognize

    bool operator==(const SliceMeasurement&) const = default;
};

}   // namespace angiopose::core
