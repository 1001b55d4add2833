#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// A diameter as it changes along a vessel.
struct DiameterLine {
    double startMm = 0.0;   ///< at arc length 0
    double slope = 0.0;   ///< mm per mm

    double at(double arcMm) const { return startMm + slope * arcMm; }
};

/// The line through those of the diameters, (arc length, diameter) in mm, that belong to a healthy vessel: fitted to
/// all, then again without those that lie too far below it or above it, ever more strictly (to 10 % and 20 %). Nothing
/// from fewer than 6 diameters, or where fewer than a quarter of them agree.
std::optional<DiameterLine> referenceLine(const std::vector<Eigen::Vector2d>& diameters);

}   // namespace angiopose::core
