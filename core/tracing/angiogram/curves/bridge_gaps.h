#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// The mask with short gaps in vessels closed: where a skeleton end points at another component no more than `reachPx`
/// ahead and the ridge between them is at least `minRidge` on average, a line joins them.
Mask2d withGapsBridged(const Mask2d& mask, const ImageF& ridges, double reachPx, double minRidge);

}   // namespace angiopose::core