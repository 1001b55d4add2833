#pragma once

#include "core/imaging/image2d.h"
#include "core/tracing/angiogram/ridges/vesselness.h"

#include <vector>

namespace angiopose::core {

/// Estimates the ridge strength in places without vessels from the ridges of the opposite sign. Contrast agent only
/// darkens, while noise and background both darken and brighten, so bright ridges show how strong dark ridges would be
/// without vessels. In large images, only a few bands of rows are evaluated.
class ClutterEstimate {
public:
    /// Measures the clutter inside `field`.
    ClutterEstimate(const ImageF& opacity, const Mask2d& field, std::vector<RidgeScale> scales);

    /// Returns the scales, weighted so that no scale has stronger clutter than the coarsest: the finest filters respond
    /// most to noise and gray-value steps, which would otherwise hide even wide vessels.
    const std::vector<RidgeScale>& scales() const { return scales_; }

    /// Returns the clutter level: the 90 % quantile of the weighted ridges of the opposite sign, or less if their tail
    /// is as thin as that of pure noise, from which vessels stand out more easily. `ridges` is `ridgeStrength(opacity,
    /// scales())`; the neighborhood of clear vessels is excluded because their flanks are ridges of the opposite sign
    /// as well. In units of `ridges`; 0 without a field.
    double level(const ImageF& ridges) const;

private:
    Mask2d field_;
    std::vector<RidgeScale> scales_;
    ImageF inverted_;   ///< weighted ridges of the opposite sign in all bands; -1 elsewhere
};

}   // namespace angiopose::core
