#pragma once

#include "core/geometry/c_arm.h"

#include <Eigen/Core>
#include <optional>
#include <string_view>

namespace angiopose::core {

/// Position of the patient on the table (PS3.3 C.7.3.1.1.2): head first or feet first; supine, prone, or on the right
/// (DR) or left (DL) side.
enum class PatientPosition { HFS, HFP, HFDR, HFDL, FFS, FFP, FFDR, FFDL };

/// Parses a defined term such as "FFS"; returns nullopt for any other text.
std::optional<PatientPosition> parsePatientPosition(std::string_view text);

/// Returns the defined term, such as "FFS".
std::string_view toText(PatientPosition position);

/// Returns the rotation from the table frame to patient LPS, with determinant +1. The table frame is the LPS frame of a
/// patient in head-first supine position.
Eigen::Matrix3d patientFromTable(PatientPosition position);

/// C-arm angles in the patient frame, in degrees (ALGORITHMS §5.3).
struct PatientAngles {
    double primaryDeg = 0.0;
    double secondaryDeg = 0.0;
    double rollDeg = 0.0;
};

/// Interpretation of the header angles as relative to the table, that is, as if every patient lay head first supine.
struct TableAngles {
    PatientPosition position = PatientPosition::HFS;
    PatientAngles angles;   ///< angles in the patient frame, to be entered instead of those in the header
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();   ///< rotation from patient LPS to the header angles' frame
};

/// Returns the interpretation of the angles relative to the table. Returns nullopt if an angle is missing or if the
/// patient lies head first and supine, because both interpretations are then the same.
std::optional<TableAngles> anglesFromTable(const CArm& cArm, PatientPosition position);

}   // namespace angiopose::core
