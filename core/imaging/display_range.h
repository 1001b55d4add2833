#pragma once

#include "core/imaging/image2d.h"

namespace core {

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

}   // namespace core
