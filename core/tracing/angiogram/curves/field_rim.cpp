#include "core/tracing/angiogram/curves/field_rim.h"

#include <cmath>

namespace angiopose::core {
namespace {

constexpr int fieldRimPx = 10;

}   // namespace

bool isAtRim(const Eigen::Vector2d& pointPx, const Mask2d& field)
{
    const int x0 = static_cast<int>(std::lround(pointPx.x()));
    const int y0 = static_cast<int>(std::lround(pointPx.y()));
    for (int y = y0 - fieldRimPx; y <= y0 + fieldRimPx; ++y) {
        for (int x = x0 - fieldRimPx; x <= x0 + fieldRimPx; ++x) {
            const bool isNear = std::hypot(x - x0, y - y0) <= fieldRimPx;
            if (isNear && (!field.contains(x, y) || field.at(x, y) == 0)) {
                return true;
            }
        }
    }
    return false;
}

}   // namespace angiopose::core
