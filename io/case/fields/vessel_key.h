#pragma once

#include "core/tracing/volume/vessel_input.h"

#include <array>

namespace angiopose::io {

/// In the order in which a case with several of them is read.
inline constexpr std::array vesselInputKinds = {core::VesselInputKind::Centerline, core::VesselInputKind::Segmentation,
                                                core::VesselInputKind::Surface, core::VesselInputKind::Volume};

/// The key of a kind of input under `vessel` (FORMATS §2).
constexpr const char* vesselKey(core::VesselInputKind kind)
{
    constexpr std::array keys = {"centerline", "segmentation", "surface", "volume"};
    return keys[static_cast<std::size_t>(kind)];
}

}   // namespace angiopose::io