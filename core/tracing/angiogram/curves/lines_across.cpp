#include "core/tracing/angiogram/curves/lines_across.h"

#include "core/tracing/angiogram/curves/bend_of_path.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double leastShareAcross = 0.5;   // shorter ones may cut a corner
constexpr double largestBend = 0.01;   // root mean square distance from a line, relative to the length
constexpr int lineRimPx = 10;

/// Whether the field ends within `rimPx` of a point, or the image does.
bool isAtRim(const Eigen::Vector2d& point, const Mask2d& field)
{
    const int x0 = static_cast<int>(std::lround(point.x()));
    const int y0 = static_cast<int>(std::lround(point.y()));
    for (int y = y0 - lineRimPx; y <= y0 + lineRimPx; ++y) {
        for (int x = x0 - lineRimPx; x <= x0 + lineRimPx; ++x) {
            const bool isNear = std::hypot(x - x0, y - y0) <= lineRimPx;
            if (isNear && (!field.contains(x, y) || field.at(x, y) == 0)) {
                return true;
            }
        }
    }
    return false;
}

}   // namespace

bool runsStraightAcross(const std::vector<Eigen::Vector2d>& pathPx, const Mask2d& field)
{
    const double chord = pathPx.size() < 2 ? 0.0 : (pathPx.back() - pathPx.front()).norm();
    return chord >= leastShareAcross * std::min(field.width, field.height) &&
           deviationFromLine(pathPx) <= largestBend * chord && isAtRim(pathPx.front(), field) &&
           isAtRim(pathPx.back(), field);
}

}   // namespace angiopose::core