#pragma once

#include "core/exchange/diffdrr_view.h"
#include "core/geometry/posed_camera.h"
#include "core/support/result.h"
#include "io/pose/diffdrr_text.h"

#include <string>

namespace angiopose::io {

/// Reads a view from DiffDRR or xvr: JSON, or xvr's table of iterations (`.csv`), which lacks the detector.
core::Result<DiffDrrParts> readDiffDrr(const std::string& path);

/// Returns the view with its detector; fails and names the part if one is missing. Without a volume center, assumes the
/// patient origin.
core::Result<core::PosedCamera> posedCameraFrom(const DiffDrrParts& parts);

core::Status writeDiffDrr(const core::DiffDrrView& view, const std::string& path);

}   // namespace angiopose::io
