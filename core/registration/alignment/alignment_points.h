#pragma once

#include "core/registration/alignment/projected_point.h"
#include "core/registration/problem/registration_problem.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Returns the smallest stride that keeps at most `wanted` of `count` points.
std::size_t strideFor(std::size_t count, std::size_t maxCount);

/// Every `stride`-th tree point.
std::vector<AlignmentPoint> alignmentPoints(const TreeSamples& tree, std::size_t stride = 1);

/// Selects the informative tree points by skipping points closer than `informativeSpacingPx` to the previous point of
/// their branch. The target is sampled about once per pixel; denser tree points would count the same displacement
/// several times.
inline constexpr double informativeSpacingPx = 1.5;
std::vector<AlignmentPoint> informativePoints(const TreeSamples& tree, double mmPerPx,
                                              double spacingPx = informativeSpacingPx);

/// Tree points with the given indices.
std::vector<AlignmentPoint> alignmentPoints(const TreeSamples& tree, const std::vector<int>& numbers);

}   // namespace angiopose::core
