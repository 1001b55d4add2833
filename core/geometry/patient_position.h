#pragma once

#include "core/geometry/c_arm.h"

#include <Eigen/Core>
#include <optional>
#include <string_view>

namespace angiopose::core {

/// Position of the patient on the table (PS3.3 C.7.3.1.1.2): head or feet first; supine, prone, or on the right (DR) or
/// left (DL) side.
enum class PatientPosition { HFS, HFP, HFDR, HFDL, FFS, FFP, FFDR, FFDL };

/// Parses the defined term; nothing for any other text.
std::optional<PatientPosition> patientPositionFrom(std::string_view text);

/// Returns the defined term: "FFS".
std::string_view toText(PatientPosition position);

/// Returns the rotation from the table's frame to the patient's LPS. The table's frame is the LPS of a patient lying
/// head first and supine. det = +1.
Eigen::Matrix3d patientFromTable(PatientPosition position);

/// C-arm angles in the patient's frame, degrees (ALGORITHMS §5.3).
struct PatientAngles {
    double primaryDeg = 0.0;
    double secondaryDeg = 0.0;
    double rollDeg = 0.0;
};

/// Interpretation of header angles from a device that measures them relative to the table, as if every patient lay head
/// first and supine.
struct TableReading {
    PatientPosition position = PatientPosition::HFS;
    PatientAngles angles;   ///< angles to enter instead of those in the header
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();   ///< rotation from patient LPS to the header angles' frame
};

/// Returns nothing if the patient lies head first and supine, because both readings are then equal, or if an angle is
/// missing.
std::optional<TableReading> countedFromTable(const CArm& cArm, PatientPosition position);

}   // namespace angiopose::core
