#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Grey values that are shown black and white.
struct DisplayRange {
    double low = 0.0;
    double high = 1.0;

    double window() const { return high - low; }
    double level() const { return 0.5 * (low + high); }
};

/// Range that shows the vessels well: from the 0.5th to the 99.5th percentile of the pixels inside the exposed field
/// (a large border of one extreme value does not count), widened so that the background stays a middle grey.
/// Never empty: high > low.
DisplayRange displayRange(const ImageF& frame);

/// Range for the vessels alone: from their extreme to the background (the median inside the exposed field), which
/// becomes white behind dark vessels and black behind bright ones. Never empty.
DisplayRange vesselRange(const ImageF& frame, Polarity polarity);

}   // namespace angiopose::core