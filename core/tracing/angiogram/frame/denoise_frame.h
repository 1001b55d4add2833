#pragma once

#include "core/imaging/image2d.h"

#include <vector>

namespace angiopose::core {

/// Returns the frame with less noise where the run is static: averages the frame with up to four frames before and
/// after that differ from it only by noise (phantom, late phase under breath-hold). The search stops on each side at
/// the first frame with more than 1 % changed pixels, so frames of a beating heart stay unchanged. Changed pixels are
/// not averaged. `index` must exist.
ImageF denoiseFrame(const std::vector<ImageF>& frames, int index);

}   // namespace angiopose::core
