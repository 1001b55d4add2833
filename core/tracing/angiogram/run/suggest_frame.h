#pragma once

#include "core/imaging/angiogram.h"

#include <vector>

namespace angiopose::core {

/// Opacified share of the field in each frame, 0…1: the share of pixels in ridges above a threshold common to all
/// frames. 0 for frames that cannot be traced (empty, of another size, not finite, of one color). Nothing counts beyond
/// the `shutter` (see `findField`).
std::vector<double> opacificationCurve(const std::vector<ImageF>& frames, Polarity polarity,
                                       const Mask2d& shutter = {});

/// The peak-opacification frame: the middle one of those with nearly the maximum opacification; 0 if there are no
/// frames.
int suggestFrame(const std::vector<ImageF>& frames, Polarity polarity, const Mask2d& shutter = {});

}   // namespace angiopose::core