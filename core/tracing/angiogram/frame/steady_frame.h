#pragma once

#include "core/imaging/image2d.h"

#include <vector>

namespace angiopose::core {

/// Reduces noise where the run is static: averages the frame with up to four frames before and after it, as long as
/// they differ from it only by noise (a phantom, a late phase under breath-hold). A frame in which more than 1 % of the
/// pixels have changed ends the search on its side, so the frame of a beating heart stays unchanged. Changed pixels are
/// not averaged. `index` must exist.
ImageF steadyFrame(const std::vector<ImageF>& frames, int index);

}   // namespace angiopose::core