#pragma once

#include "core/tracing/volume/vessel_input.h"

#include <array>

namespace angiopose::io {

/// Kinds of vessel input in order of precedence, for cases that contain several.
inline constexpr std::array vesselInputKinds = {core::VesselInputKind::Centerline, core::VesselInputKind::Segmentation,
                                                core::VesselInputKind::Surface, core::VesselInputKind::Volume};

/// Returns the key of an input kind under `vessel` (FORMATS §2).
constexpr const char* vesselKey(core::VesselInputKind kind)
{
    constexpr std::array keys = {"centerline", "segmentation", "surface", "volume"};
    return keys[static_cast<std::size_t>(kind)];
}

}   // namespace angiopose::io
