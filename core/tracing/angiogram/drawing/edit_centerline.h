#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

// Edits of a traced centreline, each giving a new one: undo is to keep the old. A curve that falls apart leaves its id
// to its first part; further parts, and drawn curves, get ids above all others. Parts of a single point are dropped.

/// What lies outside the disc.
Centerline2d erased(const Centerline2d& centerline, const Eigen::Vector2d& centerPx, double radiusPx);

/// What lies inside the polygon (closed by itself, even-odd rule); everything for fewer than three corners.
Centerline2d restrictedTo(const Centerline2d& centerline, const std::vector<Eigen::Vector2d>& polygonPx);

/// What lies outside the polygon; everything for fewer than three corners.
Centerline2d withoutRegion(const Centerline2d& centerline, const std::vector<Eigen::Vector2d>& polygonPx);

/// The curve nearest to `pointPx` in two, at its point nearest to it; unchanged at a curve's end, or if none is near.
Centerline2d cutAt(const Centerline2d& centerline, const Eigen::Vector2d& pointPx, double reachPx = 10.0);

/// Without the curve of this id: marked as no vessel.
Centerline2d withoutCurve(const Centerline2d& centerline, int id);

/// With a drawn path as a further curve: smoothed, centred and measured on `opacity` (see `flattenBackground`; vessels
/// positive) if that is not empty. Unchanged for fewer than two points.
Centerline2d withDrawn(const Centerline2d& centerline, const std::vector<Eigen::Vector2d>& pathPx,
                       const ImageF& opacity = {}, double maxRadiusPx = 8.0);

/// Id of the curve nearest to `pointPx`; -1 if none is within reach.
int curveAt(const Centerline2d& centerline, const Eigen::Vector2d& pointPx, double reachPx = 10.0);

}   // namespace angiopose::core