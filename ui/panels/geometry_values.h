#pragma once

#include "core/geometry/c_arm.h"
#include "core/geometry/gantry_header.h"
#include "core/support/message.h"
#include "ui/controls/number_field.h"

#include <QString>

#include <array>
#include <optional>

namespace angiopose::ui {

/// Values shown by the geometry panel.
struct GeometryState {
    core::CArm cArm;
    std::vector<core::HeaderTag> headerTags;
    Eigen::Vector2i imageSizePx = Eigen::Vector2i::Zero();   ///< columns and rows; zero without an image
    Eigen::Vector2d gantryRotationDeg =
        Eigen::Vector2d::Zero();   ///< gantry rotation of this frame relative to the first one
    std::optional<Eigen::Vector3d> vesselCentroidMm;   ///< used in place of an unknown isocenter
    std::optional<core::ProjectionCamera> cameraOverride;   ///< from the case file; overrides distances and spacing
    std::optional<double> vesselMmPerPx;   ///< scale at the vessels; requires a pose
    core::Messages contradictions;
    QString missing;   ///< inputs still missing for the camera or the initial pose; empty if complete
};

/// Numeric C-arm parameters that can be edited.
enum class GeometryValue {
    Sid,
    Sod,
    Spacing,
    FieldWidth,   ///< detector width, from which the spacing can be derived
    Primary,
    Secondary,
    Roll,
    CenterX,
    CenterY,
    IsocenterX,
    IsocenterY,
    IsocenterZ
};
inline constexpr std::size_t geometryValueCount = 12;
inline constexpr GeometryValue firstAdvancedValue = GeometryValue::Roll;   ///< first value of the collapsed section

/// Label and number format of a value, and the typical value assumed if it is unknown.
struct GeometryValueInfo {
    const char* label;
    const char* help;
    NumberFormat format;
    double typical;
    bool isRequired;   ///< whether the camera or the initial pose requires the value
};
const GeometryValueInfo& infoOf(GeometryValue value);

/// Returns the value in use: that of the case, or its substitute.
core::SourcedValue<double> shownValue(const GeometryState& state, GeometryValue value);

/// Returns the C-arm of `state` with `value` set to `number`, either entered or assumed.
core::CArm withValue(const GeometryState& state, GeometryValue value, double number, core::Origin origin,
                     const std::string& basis);

}   // namespace angiopose::ui
