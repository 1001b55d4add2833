#include "core/tracing/angiogram/curves/field_edge.h"

#include <cmath>

namespace angiopose::core {
namespace {

constexpr int fieldEdgePx = 10;

}   // namespace

bool isAtFieldEdge(const Eigen::Vector2d& pointPx, const Mask2d& field)
{
    const int x0 = static_cast<int>(std::lround(pointPx.x()));
    const int y0 = static_cast<int>(std::lround(pointPx.y()));
    for (int y = y0 - fieldEdgePx; y <= y0 + fieldEdgePx; ++y) {
        for (int x = x0 - fieldEdgePx; x <= x0 + fieldEdgePx; ++x) {
            const bool isNear = std::hypot(x - x0, y - y0) <= fieldEdgePx;
            if (isNear && (!field.contains(x, y) || field.at(x, y) == 0)) {
                return true;
            }
        }
    }
    return false;
}

}   // namespace angiopose::core
