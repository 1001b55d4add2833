#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// Returns a score for how much of a frame shows opacified vessels: total length of the non-suspect curves × length of
/// the longest of them (both in units of the frame's longer side) × upper quartile of the ridge strength along them in
/// units of `clutter`, at most 15. `clutter` is the level that noise and background reach in `vesselness`. Returns 0 if
/// all curves are suspect.
double contrastScore(const Centerline2d& centerline, const std::vector<int>& suspectIds, const ImageF& vesselness,
                     double clutter);

/// Score below which a frame usually shows no opacified vessels. Tuned on the even-numbered annotated angiograms, both
/// unchanged and with their vessels painted over, and on the frames of the phantom; see the tool `contrast_table`.
constexpr double minContrast = 8.0;

/// Score from which a frame shows opacified vessels regardless of other frames: three in five annotated angiograms
/// reach it, and no frame without contrast agent does.
constexpr double definiteContrast = 20.0;

}   // namespace angiopose::core
