#pragma once

#include "core/imaging/image2d.h"

#include <vector>

namespace core {

/// Ridges no stronger than this may be noise: in noise alone Otsu finds two classes as well, but most of any frame
/// shows no vessel, so the middle ridge strength is that of noise.
double ridgeNoiseLimit(const std::vector<float>& ridges);

/// Ridge strength in units of what makes a vessel: 1 is Otsu's threshold inside the field (or the noise limit, if
/// higher) divided by `sensitivity`. 0 outside the field, and everywhere if there is no ridge.
ImageF vesselEvidence(const ImageF& ridges, const Mask2d& field, double sensitivity);

/// Pixels taken for vessel: evidence just below 1 that goes on to evidence well above it (hysteresis).
Mask2d vesselPixels(const ImageF& evidence);

}   // namespace core
