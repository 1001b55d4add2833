#pragma once

#include "core/registration/problem/registration_problem.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace angiopose::core {

/// A wire or catheter as the image shows it: one line from one end to the other.
struct WireCurve {
    std::vector<Eigen::Vector2d> pointsPx;   ///< evenly spaced
    std::vector<Eigen::Vector2d> tangents;   ///< unit
    std::vector<double> alongPx;   ///< length up to each point
    double gapShare = 0.0;   ///< of the length, bridged between curves

    std::size_t size() const { return pointsPx.size(); }
    double lengthPx() const { return alongPx.empty() ? 0.0 : alongPx.back(); }
};

/// The traced curves joined to one line, each end to the nearest free one, the longest curve first; `spacingPx` apart,
/// farther where that would make more than `maxPoints`.
WireCurve wireCurve(const TargetSamples& target, double spacingPx, std::size_t maxPoints);

/// The same from the other end.
WireCurve reversed(const WireCurve& curve);

}   // namespace angiopose::core
