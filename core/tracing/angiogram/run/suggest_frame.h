#pragma once

#include "core/imaging/angiogram.h"

#include <vector>

namespace angiopose::core {

/// How much of the field each frame shows filled with contrast, 0…1: the share of pixels in ridges above a threshold
/// common to all frames. 0 for frames that cannot be traced (empty, another size, not finite, of one colour). Nothing
/// counts beyond the `shutter` (see `findField`).
std::vector<double> opacificationCurve(const std::vector<ImageF>& frames, Polarity polarity,
                                       const Mask2d& shutter = {});

/// The fullest frame: the middle one of those with nearly the most opacification; 0 when there are no frames.
int suggestFrame(const std::vector<ImageF>& frames, Polarity polarity, const Mask2d& shutter = {});

}   // namespace angiopose::core