#pragma once

#include "core/support/result.h"
#include "core/viewing/angle_map.h"

#include <string>

namespace angiopose::io {

/// Atomically writes a map of gantry angles as CSV, one row per angle: primary_deg, secondary_deg, foreshortening,
/// overlap (0…1).
core::Status writeAngleMap(const core::AngleMap& map, const std::string& path);

}   // namespace angiopose::io
