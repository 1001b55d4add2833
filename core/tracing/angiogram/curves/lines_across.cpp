#include "core/tracing/angiogram/curves/lines_across.h"

#include "core/tracing/angiogram/curves/bend_of_path.h"
#include "core/tracing/angiogram/curves/field_rim.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double leastShareAcross = 0.5;   // shorter ones may cut a corner
constexpr double largestBend = 0.01;   // root mean square distance from a line, relative to the length

}   // namespace

bool runsStraightAcross(const std::vector<Eigen::Vector2d>& pathPx, const Mask2d& field)
{
    const double chord = pathPx.size() < 2 ? 0.0 : (pathPx.back() - pathPx.front()).norm();
    return chord >= leastShareAcross * std::min(field.width, field.height) &&
           deviationFromLine(pathPx) <= largestBend * chord && isAtRim(pathPx.front(), field) &&
           isAtRim(pathPx.back(), field);
}

}   // namespace angiopose::core