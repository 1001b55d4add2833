#pragma once

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Root mean square distance, px, of the points from the straight line that fits them best.
double deviationFromLine(const std::vector<Eigen::Vector2d>& pointsPx);

/// The same from the circle that fits best (Kåsa 1976), for points that are not in one line.
double deviationFromArc(const std::vector<Eigen::Vector2d>& pointsPx);

}   // namespace angiopose::core