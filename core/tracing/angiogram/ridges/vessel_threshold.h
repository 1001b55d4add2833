#pragma once

#include "core/imaging/image2d.h"

#include <vector>

namespace angiopose::core {

/// Returns the upper limit of ridge strength that may be noise, as a multiple of the median: most of any frame shows no
/// vessel, so the median is that of noise. (Otsu's method finds two classes even in pure noise.)
double ridgeNoiseLimit(const std::vector<float>& ridges);

/// Returns the ridge strength above which a ridge counts as a vessel: well above `clutter` (see `ClutterEstimate`) and
/// above a small fraction of the strongest ridges, divided by `sensitivity`; 0 if there is no ridge.
double vesselThreshold(const ImageF& ridges, double clutter, double sensitivity);

/// Returns the ridge strength in units of `vesselThreshold`; 0 outside the field and, if there is no ridge, everywhere.
ImageF vesselEvidence(const ImageF& ridges, const Mask2d& field, double vesselThreshold);

/// Removes the star-shaped artifacts around the ends of strong vessels, where filters still respond to the vessel but
/// `opacity` barely exceeds the surroundings.
ImageF removeStarArtifacts(ImageF ridges, const ImageF& opacity);

/// Returns the mask of vessel pixels: evidence just below 1 connected to evidence well above 1 (hysteresis), except the
/// flanks of much stronger structures close by.
Mask2d segmentVessels(const ImageF& evidence);

}   // namespace angiopose::core
