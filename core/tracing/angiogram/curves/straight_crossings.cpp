#include "core/tracing/angiogram/curves/straight_crossings.h"

#include "core/tracing/angiogram/curves/field_edge.h"
#include "core/tracing/angiogram/curves/path_curvature.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double minChordFraction = 0.5;   // minimum chord / shorter field side; shorter paths may cut off a corner
constexpr double maxDeviationFromLine = 0.01;   // maximum RMS distance from a straight line, relative to the length

}   // namespace

bool crossesFieldStraight(const std::vector<Eigen::Vector2d>& pathPx, const Mask2d& field)
{
    const double chord = pathPx.size() < 2 ? 0.0 : (pathPx.back() - pathPx.front()).norm();
    return chord >= minChordFraction * std::min(field.width, field.height) &&
           deviationFromLine(pathPx) <= maxDeviationFromLine * chord && isAtFieldEdge(pathPx.front(), field) &&
           isAtFieldEdge(pathPx.back(), field);
}

}   // namespace angiopose::core
