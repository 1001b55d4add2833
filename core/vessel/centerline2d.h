#pragma once

#include "core/support/message.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// One traced vessel of an angiogram: an ordered curve in px.
struct Curve2d {
    int id = 0;
    std::vector<Eigen::Vector2d> pointsPx;
    std::vector<double> radiusPx;   ///< one per point, or empty if unknown

    double lengthPx() const;
};

/// Curves traced in one frame.
struct Centerline2d {
    std::vector<Curve2d> curves;

    std::size_t pointCount() const;
};

/// Returns the unit tangents of an ordered curve by central differences over ±`reach` points.
std::vector<Eigen::Vector2d> tangentsOf(const std::vector<Eigen::Vector2d>& points, int reach = 2);

/// Returns the same curves with points every `spacingPx` of arc length; single points and duplicates stay unchanged.
Centerline2d resampled(const Centerline2d& centerline, double spacingPx);

/// Returns the reason why a centerline is unusable (no points, NaN); nullopt if it is valid.
std::optional<Message> findProblem(const Centerline2d& centerline);

}   // namespace angiopose::core
