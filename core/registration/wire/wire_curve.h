#pragma once

#include "core/registration/problem/registration_problem.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Guidewire or catheter in the image as one line from end to end.
struct WireCurve {
    std::vector<Eigen::Vector2d> pointsPx;   ///< evenly spaced
    std::vector<Eigen::Vector2d> tangents;   ///< unit vectors
    std::vector<double> alongPx;   ///< arc length up to each point
    double gapFraction = 0.0;   ///< fraction of the length that bridges gaps between curves

    std::size_t size() const { return pointsPx.size(); }
    double lengthPx() const { return alongPx.empty() ? 0.0 : alongPx.back(); }
};

/// Joins the traced curves into one line: starts with the longest curve and repeatedly connects the nearest free curve
/// end to an end of the line. The points are `spacingPx` apart, or farther to stay within `maxPoints`.
WireCurve wireCurve(const TargetSamples& target, double spacingPx, std::size_t maxPoints);

/// Returns the curve with its points in reverse order.
WireCurve reversed(const WireCurve& curve);

}   // namespace angiopose::core
