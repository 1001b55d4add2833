#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// Score for how much of a frame looks like opacified vessels: the total length of all non-suspect curves times the
/// length of the longest one (both in units of the frame's longer side), times how far their ridges stand out from
/// noise and background (upper quartile along them, at most 15; `clutter` is the level that noise and background reach
/// in `vesselness`). 0 if no curve is left.
double contrastSeen(const Centerline2d& centerline, const std::vector<int>& suspectIds, const ImageF& vesselness,
                    double clutter);

/// A frame below this score usually shows no opacified vessels. Chosen on the even-numbered annotated angiograms, both
/// unchanged and with their vessels painted over, and on the phantom's frames; see `contrast_table`.
constexpr double minContrast = 8.0;

/// A frame at or above this score shows opacified vessels regardless of other frames: three in five annotated
/// angiograms reach it, and no frame without contrast agent does.
constexpr double surelyContrast = 20.0;

}   // namespace angiopose::core
