#include "core/tracing/angiogram/curves/lines_across.h"

#include "core/tracing/angiogram/curves/field_rim.h"
#include "core/tracing/angiogram/curves/path_curvature.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double minShareAcross = 0.5;   // minimum chord / shorter field side; shorter paths may cut off a corner
constexpr double largestDeformation = 0.01;   // maximum RMS distance from a straight line, relative to the length

}   // namespace

bool runsStraightAcross(const std::vector<Eigen::Vector2d>& pathPx, const Mask2d& field)
{
    const double chord = pathPx.size() < 2 ? 0.0 : (pathPx.back() - pathPx.front()).norm();
    return chord >= minShareAcross * std::min(field.width, field.height) &&
           deviationFromLine(pathPx) <= largestDeformation * chord && isAtRim(pathPx.front(), field) &&
           isAtRim(pathPx.back(), field);
}

}   // namespace angiopose::core
