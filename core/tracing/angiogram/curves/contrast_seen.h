#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// How much in a frame looks like vessels filled with contrast medium: the length of all curves that are no suspects
/// times that of the longest (both in longer sides of the frame), times how far their ridges stand out from noise and
/// background (upper quartile along them, at most 15; `clutter` is what those reach in `vesselness`). 0 where nothing
/// is left.
double contrastSeen(const Centerline2d& centerline, const std::vector<int>& suspectIds, const ImageF& vesselness,
                    double clutter);

/// Less than this is no vessel filled with contrast medium, as a rule. Chosen on the even ones of the annotated
/// angiograms, as they are and with their vessels painted over, and the phantom's frames; see `contrast_table`.
constexpr double minContrast = 8.0;

/// From here on vessels are filled, whatever another frame shows: three in five annotated angiograms reach it, no
/// frame without contrast medium does.
constexpr double surelyContrast = 20.0;

}   // namespace angiopose::core
