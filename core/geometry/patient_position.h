#pragma once

#include "core/geometry/c_arm.h"

#include <Eigen/Core>
#include <optional>
#include <string_view>

namespace angiopose::core {

/// How a patient lies on the table (PS3.3 C.7.3.1.1.2): head or feet first; supine, prone, or on the right (DR) or left
/// (DL) side.
enum class PatientPosition { HFS, HFP, HFDR, HFDL, FFS, FFP, FFDR, FFDL };

/// Nothing for another word.
std::optional<PatientPosition> patientPositionFrom(std::string_view text);

/// The defined term: "FFS".
std::string_view toText(PatientPosition position);

/// Turns directions of the table into the patient's LPS. The table's frame is the LPS of somebody who lies head first
/// and supine. det = +1.
Eigen::Matrix3d patientFromTable(PatientPosition position);

/// Angles of a C-arm in the patient's frame, degrees (ALGORITHMS §5.3).
struct PatientAngles {
    double primaryDeg = 0.0;
    double secondaryDeg = 0.0;
    double rollDeg = 0.0;
};

/// A device that counts its angles from the table, as if everybody lay head first and supine: what its header means.
struct TableReading {
    PatientPosition position = PatientPosition::HFS;
    PatientAngles angles;   ///< to type instead of the header's
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();   ///< turns the patient's LPS to what the header's angles see
};

/// Nothing where the patient lies head first and supine, since both readings are one then, or an angle is missing.
std::optional<TableReading> countedFromTable(const CArm& cArm, PatientPosition position);

}   // namespace angiopose::core
