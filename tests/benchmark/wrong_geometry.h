#pragma once

#include "tests/benchmark/foreign/targets.h"

namespace angiopose::benchmarks {

/// What is told wrongly about an image.
enum class GeometryError {
    None,
    Distance,
    Spacing,
    PrincipalPoint,
    MirroredLeftRight,
    MirroredUpDown,
    Turned,
    UpsideDown
};

struct NamedError {
    GeometryError error;
    std::string_view key;   ///< for the command line
    std::string_view words;
    std::string_view message;   ///< id, or the start of it, of the message that should name the error
};
inline constexpr std::array<NamedError, 8> geometryErrors{{
    {GeometryError::None, "exact", "nothing", ""},
    {GeometryError::Distance, "sid", "source to detector 5 %", "camera.focal"},
    {GeometryError::Spacing, "spacing", "pixel spacing 3 %", "camera.focal"},
    {GeometryError::PrincipalPoint, "principal", "principal point 20 px", "camera.principal"},
    {GeometryError::MirroredLeftRight, "mirrored", "mirrored left to right", "frame.mirrored-left-right"},
    {GeometryError::MirroredUpDown, "flipped", "mirrored up to down", "frame.mirrored-up-down"},
    {GeometryError::Turned, "turned", "turned by 90°", "frame.turned-"},
    {GeometryError::UpsideDown, "upside-down", "turned by 180°", "frame.upside-down"},
}};

/// Whether the pose has a truth that the camera told admits: of a mirrored image it has none.
bool hasTruth(GeometryError error);

/// Makes the geometry that is told of the image wrong, or the image unlike its geometry. Every second trial errs the
/// other way; principal points err in a direction of their own.
void spoil(core::RegistrationInput& input, GeometryError error, std::uint64_t trial);

/// How far a camera may be off whose distances and spacing come from a header, and whose principal point is assumed.
core::CameraSpread spreadOfHeader(const core::ProjectionCamera& camera);

}   // namespace angiopose::benchmarks
