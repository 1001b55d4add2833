#pragma once

#include "core/imaging/image2d.h"

#include <optional>

namespace angiopose::core {

/// The mask that a picture of two levels is, apart from blurred edges: vessels white on a larger black ground. Nothing
/// for any other picture; a frame of an X-ray run is none.
std::optional<Mask2d> drawnMask(const ImageF& picture);

}   // namespace angiopose::core