#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>

namespace angiopose::core {

/// Adds a disc of constant height `value` with smooth edges. Its volume is exact, which makes position and width
/// accurate to a fraction of a pixel. Discs along a line add up to the chord profile 2√(r² − ρ²) of a tube.
void splatDisc(ImageF& image, const Eigen::Vector2d& centerPx, double radiusPx, double value);

}   // namespace angiopose::core
