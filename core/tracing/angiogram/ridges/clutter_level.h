#pragma once

#include "core/imaging/image2d.h"
#include "core/tracing/angiogram/ridges/vesselness.h"

#include <vector>

namespace angiopose::core {

/// How strong ridges get that are no vessels: seen in the ridges of the other sign. Contrast medium only ever darkens,
/// noise and background do both, so bright ridges show what dark ones would be without vessels. Large images are
/// measured in bands.
class Clutter {
public:
    /// Measures inside `field`.
    Clutter(const ImageF& opacity, const Mask2d& field, std::vector<RidgeScale> scales);

    /// The scales, weighted so that none has stronger clutter than the coarsest: noise and steps of grey values are
    /// seen by the finest filters most, and would hide even wide vessels.
    const std::vector<RidgeScale>& scales() const { return scales_; }

    /// What one in ten pixels exceeds in the weighted ridges of the other sign; less where the tail above it is as thin
    /// as that of noise, from which vessels stand out sooner. `ridges` is `ridgeStrength(opacity, scales())`: around
    /// its clear vessels, whose flanks are ridges of the other sign too, nothing is measured. Units of `ridges`; 0
    /// without a field.
    double level(const ImageF& ridges) const;

private:
    Mask2d inside_;
    std::vector<RidgeScale> scales_;
    ImageF inverted_;   ///< weighted ridges of the other sign in all bands; -1 elsewhere
};

}   // namespace angiopose::core