#pragma once

#include "core/imaging/image2d.h"

#include <optional>

namespace angiopose::core {

/// Interprets a two-level image (apart from blurred edges) as a vessel mask: white vessels on a larger black
/// background. Nothing for any other image, including frames of an X-ray run.
std::optional<Mask2d> drawnMask(const ImageF& picture);

}   // namespace angiopose::core