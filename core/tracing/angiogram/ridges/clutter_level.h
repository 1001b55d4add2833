#pragma once

#include "core/imaging/image2d.h"
#include "core/tracing/angiogram/ridges/vesselness.h"

#include <vector>

namespace angiopose::core {

/// Estimates how strong ridges get where there is no vessel, from the ridges of the opposite sign. Contrast agent only
/// darkens, while noise and background both darken and brighten, so bright ridges show how strong dark ones would be
/// without vessels. Large images are measured in bands.
class Clutter {
public:
    /// Measures inside `field`.
    Clutter(const ImageF& opacity, const Mask2d& field, std::vector<RidgeScale> scales);

    /// The scales, weighted so that none has stronger clutter than the coarsest: the finest filters respond most to
    /// noise and gray-value steps, which would otherwise hide even wide vessels.
    const std::vector<RidgeScale>& scales() const { return scales_; }

    /// Level that one in ten pixels exceeds in the weighted ridges of the opposite sign; lower if the tail above it is
    /// as thin as that of noise, from which vessels stand out sooner. `ridges` is `ridgeStrength(opacity, scales())`;
    /// the surroundings of its clear vessels are left out, because their flanks are ridges of the opposite sign too. In
    /// units of `ridges`; 0 without a field.
    double level(const ImageF& ridges) const;

private:
    Mask2d inside_;
    std::vector<RidgeScale> scales_;
    ImageF inverted_;   ///< weighted ridges of the opposite sign in all bands; -1 elsewhere
};

}   // namespace angiopose::core