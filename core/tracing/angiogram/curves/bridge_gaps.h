#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Returns the mask with short gaps in vessels closed: draws a line from each skeleton end to the component at which it
/// points if that is at most `reachPx` ahead and the mean ridge strength along the line is at least `minRidge`.
Mask2d bridgeGaps(const Mask2d& mask, const ImageF& ridges, double reachPx, double minRidge);

}   // namespace angiopose::core
