#pragma once

#include "core/support/result.h"
#include "core/workflow/track_frames.h"

#include <span>
#include <string>

namespace angiopose::io {

/// Atomically writes a CSV with one pose per frame: frame, `trustworthy` (1 or 0), searched, score, and
/// cameraFromPatient as r11 … r33, tx, ty, tz (mm), row-major, with full double precision; mean and maximum deformation
/// of the vessels relative to that pose (mm), empty if there is none.
core::Status writePoseTable(std::span<const core::TrackedRunFrame> frames, const std::string& path);

}   // namespace angiopose::io
