#include "core/geometry/patient_position.h"

#include "core/geometry/angle_units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace angiopose::core {
namespace {

struct NamedPosition {
    PatientPosition position;
    std::string_view name;
    std::array<int, 3> left;   ///< direction of the patient's left in the table frame
    std::array<int, 3> head;
};

constexpr std::array namedPositions{
    NamedPosition{PatientPosition::HFS, "HFS", {1, 0, 0}, {0, 0, 1}},
    NamedPosition{PatientPosition::HFP, "HFP", {-1, 0, 0}, {0, 0, 1}},
    NamedPosition{PatientPosition::HFDR, "HFDR", {0, -1, 0}, {0, 0, 1}},   // right side down: left points up
    NamedPosition{PatientPosition::HFDL, "HFDL", {0, 1, 0}, {0, 0, 1}},
    NamedPosition{PatientPosition::FFS, "FFS", {-1, 0, 0}, {0, 0, -1}},
    NamedPosition{PatientPosition::FFP, "FFP", {1, 0, 0}, {0, 0, -1}},
    NamedPosition{PatientPosition::FFDR, "FFDR", {0, -1, 0}, {0, 0, -1}},
    NamedPosition{PatientPosition::FFDL, "FFDL", {0, 1, 0}, {0, 0, -1}},
};

const NamedPosition& entryOf(PatientPosition position)
{
    return *std::ranges::find(namedPositions, position, &NamedPosition::position);
}

Eigen::Vector3d vectorOf(const std::array<int, 3>& axis)
{
    return {static_cast<double>(axis[0]), static_cast<double>(axis[1]), static_cast<double>(axis[2])};
}

Eigen::Matrix3d rotationAt(const CArm& anyDistance, const PatientAngles& angles)
{
    CArm cArm = anyDistance;
    cArm.sourceToIsocenterMm = {1.0, Origin::Assumed, ""};
    cArm.primaryAngleDeg.value = angles.primaryDeg;
    cArm.secondaryAngleDeg.value = angles.secondaryDeg;
    cArm.rollDeg.value = angles.rollDeg;
    return cameraFromPatient(cArm, Eigen::Vector3d::Zero()).value().rotation;
}

/// Returns the angles at which a patient's C-arm has this rotation.
PatientAngles anglesOf(const Eigen::Matrix3d& cameraFromPatientRotation, const CArm& cArm)
{
    const Eigen::Vector3d direction = cameraFromPatientRotation.row(2);
    PatientAngles angles;
    angles.secondaryDeg = std::asin(std::clamp(direction.z(), -1.0, 1.0)) / radiansPerDegree;
    angles.primaryDeg = std::atan2(direction.x(), -direction.y()) / radiansPerDegree;
    const Eigen::Matrix3d roll = cameraFromPatientRotation * rotationAt(cArm, angles).transpose();
    const double aboutZDeg = std::atan2(roll(1, 0), roll(0, 0)) / radiansPerDegree;
    angles.rollDeg = cArm.mirrored.value.value_or(false) ? aboutZDeg : -aboutZDeg;
    return angles;
}

}   // namespace

std::optional<PatientPosition> parsePatientPosition(std::string_view text)
{
    const auto* const found = std::ranges::find(namedPositions, text, &NamedPosition::name);
    return found == namedPositions.end() ? std::nullopt : std::optional(found->position);
}

std::string_view toText(PatientPosition position)
{
    return entryOf(position).name;
}

Eigen::Matrix3d patientFromTable(PatientPosition position)
{
    const Eigen::Vector3d left = vectorOf(entryOf(position).left);
    const Eigen::Vector3d head = vectorOf(entryOf(position).head);
    Eigen::Matrix3d rotation;
    rotation << left.transpose(), head.cross(left).transpose(), head.transpose();
    return rotation;
}

std::optional<TableAngles> anglesFromTable(const CArm& cArm, PatientPosition position)
{
    const auto primary = cArm.primaryAngleDeg.value, secondary = cArm.secondaryAngleDeg.value;
    if (position == PatientPosition::HFS || !primary || !secondary || !std::isfinite(*primary) ||
        !std::isfinite(*secondary)) {
        return {};
    }
    TableAngles reading{position, {}, patientFromTable(position).transpose()};
    const PatientAngles counted{*primary, *secondary, cArm.rollDeg.value.value_or(0.0)};
    reading.angles = anglesOf(rotationAt(cArm, counted) * reading.turn, cArm);
    return reading;
}

}   // namespace angiopose::core
