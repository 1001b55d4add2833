#pragma once

#include "core/imaging/image2d.h"

#include <vector>

namespace angiopose::core {

/// Upper limit of the ridge strength that may be noise. Otsu finds two classes even in pure noise, but most of any
/// frame shows no vessel, so the median ridge strength is that of noise.
double ridgeNoiseLimit(const std::vector<float>& ridges);

/// Ridge strength above which a ridge counts as a vessel: well above `clutter` (see `Clutter`) and above a small share
/// of the strongest ridges, divided by `sensitivity`. 0 if there is no ridge.
double clearRidge(const ImageF& ridges, double clutter, double sensitivity);

/// Ridge strength in units of `clearRidge`; 0 outside the field, and everywhere if there is no ridge.
ImageF vesselEvidence(const ImageF& ridges, const Mask2d& field, double clearRidge);

/// Removes the star-shaped ridges around the end of a strong vessel, where filters still respond to the vessel but
/// `opacity` is hardly above the surroundings.
ImageF withoutStars(ImageF ridges, const ImageF& opacity);

/// Mask of vessel pixels: evidence just below 1 that is connected to evidence well above it (hysteresis), unless it is
/// the flank of a much stronger structure close by.
Mask2d vesselPixels(const ImageF& evidence);

}   // namespace angiopose::core