#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

// Edits of a traced centerline. Each function returns a new centerline, so undo means keeping the old one. When a curve
// is split, the first part keeps its id; further parts and drawn curves get ids above all others. Single-point parts
// are dropped.

/// Keeps the points outside the disc.
Centerline2d eraseDisc(const Centerline2d& centerline, const Eigen::Vector2d& centerPx, double radiusPx);

/// Keeps the points inside the polygon (closed implicitly, even-odd rule), or all points if the polygon has fewer than
/// three corners.
Centerline2d cropToPolygon(const Centerline2d& centerline, const std::vector<Eigen::Vector2d>& polygonPx);

/// Keeps the points outside the polygon, or all points if the polygon has fewer than three corners.
Centerline2d erasePolygon(const Centerline2d& centerline, const std::vector<Eigen::Vector2d>& polygonPx);

/// Splits the curve nearest to `pointPx` at its point nearest to `pointPx`. Changes nothing at the end of a curve or if
/// no curve is within reach.
Centerline2d splitAt(const Centerline2d& centerline, const Eigen::Vector2d& pointPx, double reachPx = 10.0);

/// Removes the curve with this id, which the user marked as not a vessel.
Centerline2d removeCurve(const Centerline2d& centerline, int id);

/// Adds a drawn path as a new curve, smoothed, and centered and measured on `opacity` (see `flattenBackground`; vessels
/// positive) unless that is empty. A path with fewer than two points adds nothing.
Centerline2d addDrawnCurve(const Centerline2d& centerline, const std::vector<Eigen::Vector2d>& pathPx,
                           const ImageF& opacity = {}, double maxRadiusPx = 8.0);

/// Returns the id of the curve nearest to `pointPx`; -1 if no curve is within reach.
int curveAt(const Centerline2d& centerline, const Eigen::Vector2d& pointPx, double reachPx = 10.0);

}   // namespace angiopose::core
