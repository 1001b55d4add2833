#pragma once

#include "core/imaging/image2d.h"

#include <vector>

namespace angiopose::core {

/// Ridges no stronger than this may be noise: in noise alone Otsu finds two classes as well, but most of any frame
/// shows no vessel, so the middle ridge strength is that of noise.
double ridgeNoiseLimit(const std::vector<float>& ridges);

/// The ridge strength that makes a vessel: well above `clutter` (see `Clutter`) and above a small share of the
/// strongest ridges, divided by `sensitivity`. 0 if there is no ridge.
double clearRidge(const ImageF& ridges, double clutter, double sensitivity);

/// Ridge strength in units of `clearRidge`. 0 outside the field, and everywhere if there is no ridge.
ImageF vesselEvidence(const ImageF& ridges, const Mask2d& field, double clearRidge);

/// The ridges without those in the star around the end of a strong vessel: there filters still see the vessel, but
/// `opacity` is hardly above the surroundings.
ImageF withoutStars(ImageF ridges, const ImageF& opacity);

/// Pixels taken for vessel: evidence just below 1 that goes on to evidence well above it (hysteresis), unless it is the
/// flank of something much stronger close by.
Mask2d vesselPixels(const ImageF& evidence);

}   // namespace angiopose::core