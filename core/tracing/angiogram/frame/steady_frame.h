#pragma once

#include "core/imaging/image2d.h"

#include <vector>

namespace angiopose::core {

/// The frame with less noise where the run stands still: the mean with the frames up to four before and after it, as
/// far as nothing but noise tells them from it (a phantom, a late phase under breath-hold). A frame in which more than
/// one pixel in a hundred has changed ends the search to its side, so a beating heart leaves the frame as it is.
/// Pixels that have changed take no part. `index` must exist.
ImageF steadyFrame(const std::vector<ImageF>& frames, int index);

}   // namespace angiopose::core