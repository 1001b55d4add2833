#pragma once

#include "core/exchange/diffdrr_view.h"
#include "core/geometry/sight.h"
#include "core/support/result.h"
#include "io/pose/diffdrr_text.h"

#include <string>

namespace angiopose::io {

/// A view of DiffDRR or xvr: JSON, or the table of xvr's way (`.csv`), which lacks the detector.
core::Result<DiffDrrParts> readDiffDrr(const std::string& path);

/// The view with its detector; fails naming what is missing. Without a centre the volume lies about its origin.
core::Result<core::Sight> sightOf(const DiffDrrParts& parts);

core::Status writeDiffDrr(const core::DiffDrrView& view, const std::string& path);

}   // namespace angiopose::io
