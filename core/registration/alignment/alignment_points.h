#pragma once

#include "core/registration/alignment/projected_point.h"
#include "core/registration/problem/registration_problem.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Stride that leaves at most `wanted` of `count` points.
std::size_t strideFor(std::size_t count, std::size_t wanted);

/// Every `stride`-th tree point.
std::vector<AlignmentPoint> alignmentPoints(const TreeSamples& tree, std::size_t stride = 1);

/// The tree points that can tell something: none of a branch nearer than `informativeSpacingPx` to the one before. The
/// target is sampled every pixel or so; between such points it holds nothing more, and neighbours would count the same
/// displacement many times.
inline constexpr double informativeSpacingPx = 1.5;
std::vector<AlignmentPoint> informativePoints(const TreeSamples& tree, double mmPerPx,
                                              double spacingPx = informativeSpacingPx);

/// The tree points with these numbers.
std::vector<AlignmentPoint> alignmentPoints(const TreeSamples& tree, const std::vector<int>& numbers);

}   // namespace angiopose::core