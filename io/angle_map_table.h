#pragma once

#include "core/support/result.h"
#include "core/viewing/angle_map.h"

#include <string>

namespace angiopose::io {

/// Writes a map of gantry angles as CSV, one row per angle: primary_deg, secondary_deg, foreshortening, overlap (0…1).
/// Writes atomically.
core::Status writeAngleMap(const core::AngleMap& map, const std::string& path);

}   // namespace angiopose::io
