#pragma once

#include "tests/benchmark/foreign/targets.h"

namespace angiopose::benchmarks {

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
    std::string_view message;   ///< id, or its beginning, of the message that should name the error
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

/// True if a true pose exists for the given camera; a mirrored image has none.
bool hasTruth(GeometryError error);

/// Falsifies the geometry given for the image, or changes the image to contradict its geometry. Every second trial errs
/// in the opposite direction; principal points err in random directions.
void spoil(core::RegistrationInput& input, GeometryError error, std::uint64_t trial);

/// Uncertainty of a camera with distances and pixel spacing from a header and an assumed principal point.
core::CameraUncertainty spreadOfHeader(const core::ProjectionCamera& camera);

}   // namespace angiopose::benchmarks
