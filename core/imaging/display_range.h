#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Gray values that are displayed as black and as white.
struct DisplayRange {
    double low = 0.0;
    double high = 1.0;

    double window() const { return high - low; }
    double level() const { return 0.5 * (low + high); }
};

/// Returns a display range suited to the vessels: the 0.5th to the 99.5th percentile of the pixels inside the exposed
/// field (without a large border of one extreme value), widened to show the background as medium gray; high > low.
DisplayRange displayRange(const ImageF& frame);

/// Returns a display range for the vessels only: from their extreme value to the background, which is the median inside
/// the exposed field. The background is white behind dark vessels and black behind bright ones. Never empty.
DisplayRange vesselRange(const ImageF& frame, Polarity polarity);

}   // namespace angiopose::core
