#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>

namespace angiopose::core {

/// Adds a disc of constant height `value` with smooth edges; its volume is exact, which gives sub-pixel accuracy of
/// position and width. Discs along a line add up to the chord profile 2√(r² − ρ²) of a tube.
void splatDisc(ImageF& image, const Eigen::Vector2d& centerPx, double radiusPx, double value);

}   // namespace angiopose::core