#pragma once

#include "core/support/result.h"

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// A named point in the patient, as exchanged with 3D Slicer.
struct Fiducial {
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm
    std::string name;
    std::string description;

    bool operator==(const Fiducial&) const = default;
};

}   // namespace angiopose::io
