#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Closes short gaps in vessels: where a skeleton end points at another component at most `reachPx` ahead and the mean
/// ridge strength between them is at least `minRidge`, a line joins them.
Mask2d withGapsBridged(const Mask2d& mask, const ImageF& ridges, double reachPx, double minRidge);

}   // namespace angiopose::core