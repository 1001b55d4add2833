#pragma once

#include "core/imaging/image2d.h"

namespace core {

/// How strong ridges get that are no vessels: what one in ten pixels inside `field` exceeds in the ridges of the other
/// sign. Contrast medium only ever darkens, noise and background do both, so bright ridges show what dark ones would be
/// without vessels. `ridges` is `ridgeStrength(opacity, …)`: around its clear vessels, whose flanks are ridges of the
/// other sign too, nothing is measured. Large images are measured in bands. Units of `ridges`; 0 without a field.
double clutterLevel(const ImageF& opacity, const ImageF& ridges, const Mask2d& field, double minRadiusPx,
                    double maxRadiusPx);

}   // namespace core
