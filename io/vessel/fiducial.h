#pragma once

#include "core/support/result.h"

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// A named place in the patient, as 3D Slicer exchanges it.
struct Fiducial {
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm
    std::string name;
    std::string description;

    bool operator==(const Fiducial&) const = default;
};

}   // namespace angiopose::io
