#pragma once

#include "core/imaging/image2d.h"

#include <optional>

namespace angiopose::core {

/// Converts a two-level image (apart from blurred edges) to a vessel mask: white vessels on a larger black background.
/// Returns nullopt for any other image, including X-ray frames.
std::optional<Mask2d> vesselMaskFromDrawing(const ImageF& image);

}   // namespace angiopose::core
