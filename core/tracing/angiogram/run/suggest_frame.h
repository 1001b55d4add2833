#pragma once

#include "core/imaging/angiogram.h"

#include <vector>

namespace angiopose::core {

/// Returns the opacified fraction (0…1) of each frame: the fraction of pixels in ridges above a threshold common to all
/// frames; 0 for frames that cannot be traced (empty, of another size, not finite, uniform). Ignores pixels outside the
/// `shutter` (see `findField`).
std::vector<double> opacificationCurve(const std::vector<ImageF>& frames, Polarity polarity,
                                       const Mask2d& shutter = {});

/// Returns the index of the peak-opacification frame: the middle one of the frames close to the maximum opacification;
/// 0 if there are no frames.
int suggestFrame(const std::vector<ImageF>& frames, Polarity polarity, const Mask2d& shutter = {});

}   // namespace angiopose::core
