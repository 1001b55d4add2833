#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Points of several curves, one after the other; neighbours with the same curve number are joined by a line.
struct CurvePoints {
    const std::vector<Eigen::Vector2d>& points;
    const std::vector<int>& curveIndex;
};

/// Distance from `query` to the two line segments that meet in point `nearest`.
double distanceToCurve(const CurvePoints& curves, std::size_t nearest, const Eigen::Vector2d& query);

}   // namespace angiopose::core