#pragma once

#include "core/geometry/c_arm.h"
#include "core/geometry/gantry_header.h"
#include "core/support/message.h"
#include "ui/controls/number_field.h"

#include <QString>

#include <array>
#include <optional>

namespace angiopose::ui {

/// What the geometry panel shows.
struct GeometryState {
    core::CArm cArm;
    std::vector<core::HeaderTag> headerTags;
    Eigen::Vector2i imageSizePx = Eigen::Vector2i::Zero();   ///< columns, rows; zero without an image
    Eigen::Vector2d turnedDeg = Eigen::Vector2d::Zero();   ///< of the gantry at this frame since the first
    std::optional<Eigen::Vector3d> vesselCentroidMm;   ///< stands in for the isocentre
    std::optional<core::ProjectionCamera> cameraOverride;   ///< of the case file; wins over distances and spacing
    std::optional<double> vesselMmPerPx;   ///< scale at the vessels, when there is a pose
    core::Messages contradictions;
    QString missing;   ///< what keeps the camera or the start pose from being known; empty when nothing
};

/// The numbers of a C-arm that can be typed.
enum class GeometryValue {
    Sid,
    Sod,
    Spacing,
    FieldWidth,   ///< another way to tell the spacing
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
inline constexpr GeometryValue firstSeldomValue = GeometryValue::Roll;   ///< from here on: folded away

/// How a value is labelled and typed, and what to assume when nobody knows it: a usual C-arm.
struct GeometryValueKind {
    const char* label;
    const char* help;
    NumberFormat format;
    double usual;
    bool isNeeded;   ///< without it there is no camera or no start pose
};
const GeometryValueKind& kindOf(GeometryValue value);

/// The value as it holds: what the case has, or what stands in for it.
core::Sourced<double> shownValue(const GeometryState& state, GeometryValue value);

/// The C-arm with this value typed, or assumed.
core::CArm withValue(const GeometryState& state, GeometryValue value, double number, core::Origin origin,
                     const std::string& basis);

}   // namespace angiopose::ui