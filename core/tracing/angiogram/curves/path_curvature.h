#pragma once

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Returns the RMS distance, px, of the points from the best-fit straight line.
double deviationFromLine(const std::vector<Eigen::Vector2d>& pointsPx);

/// Returns the RMS distance, px, of the points from the best-fit circle (Kåsa 1976); the points must not be collinear.
double deviationFromArc(const std::vector<Eigen::Vector2d>& pointsPx);

}   // namespace angiopose::core
