#pragma once

#include "core/registration/alignment/projected_point.h"
#include "core/registration/problem/registration_problem.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Returns the smallest stride that keeps at most `maxCount` of `count` points.
std::size_t strideFor(std::size_t count, std::size_t maxCount);

/// Returns every `stride`-th tree point.
std::vector<AlignmentPoint> alignmentPoints(const TreeSamples& tree, std::size_t stride = 1);

/// Minimum distance of an informative tree point from the previous one of its branch. The target is sampled about once
/// per pixel, so denser tree points would count the same displacement several times.
inline constexpr double informativeSpacingPx = 1.5;
std::vector<AlignmentPoint> informativePoints(const TreeSamples& tree, double mmPerPx,
                                              double spacingPx = informativeSpacingPx);

/// Returns the tree points with the given indices.
std::vector<AlignmentPoint> alignmentPoints(const TreeSamples& tree, const std::vector<int>& numbers);

}   // namespace angiopose::core
