#pragma once

#include "core/imaging/image2d.h"

#include <vector>

namespace core {

/// Ridges no stronger than this may be noise: in noise alone Otsu finds two classes as well, but most of any frame shows
/// no vessel, so the middle ridge strength is that of noise.
double ridgeNoiseLimit(const std::vector<float>& ridges);

/// Pixels taken for vessel: ridges above a low threshold that are connected to one above the high (Otsu's) one.
/// Above 1, `sensitivity` lowers both.
Mask2d thresholdVessels(const ImageF& ridges, const Mask2d& field, double sensitivity);

}   // namespace core
