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
    std::vector<double> radiusPx;   ///< one per point, or empty when unknown

    double lengthPx() const;
};

/// What was traced in one frame.
struct Centerline2d {
    std::vector<Curve2d> curves;

    std::size_t pointCount() const;
};

/// Unit tangents of an ordered curve by central differences over ±`reach` points.
std::vector<Eigen::Vector2d> tangentsOf(const std::vector<Eigen::Vector2d>& points, int reach = 2);

/// The same curves with points every `spacingPx` of arc length; single points and duplicates survive as they are.
Centerline2d resampled(const Centerline2d& centerline, double spacingPx);

/// What makes this centreline unusable (no points, NaN), in words for the user; empty when it is fine.
std::optional<Message> findProblem(const Centerline2d& centerline);

}   // namespace angiopose::core