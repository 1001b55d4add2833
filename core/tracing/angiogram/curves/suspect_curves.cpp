#include "core/tracing/angiogram/curves/suspect_curves.h"

#include "core/support/quantile.h"
#include "core/tracing/angiogram/curves/bend_of_path.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double leastShareOfSuspect = 0.15;
constexpr double evenBendPx = 0.5;   // rms from the best arc, of short curves
constexpr double evenBendPerLength = 0.004;   // and of long ones
constexpr double evenWidth = 0.2;   // spread, and change from one half to the other, relative to the width

bool bendsEvenly(const Curve2d& curve)
{
    const double tolerance = std::max(evenBendPx, evenBendPerLength * curve.lengthPx());
    return deviationFromLine(curve.pointsPx) <= tolerance || deviationFromArc(curve.pointsPx) <= tolerance;
}

bool keepsItsWidth(const std::vector<double>& radii)
{
    const std::vector<double> spread = quantiles(radii, {0.16, 0.5, 0.84});
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    const double change = quantile({radii.begin(), middle}, 0.5) - quantile({middle, radii.end()}, 0.5);
    return 0.5 * (spread[2] - spread[0]) <= evenWidth * spread[1] && std::abs(change) <= evenWidth * spread[1];
}

}   // namespace

std::vector<int> suspectCurves(const Centerline2d& centerline, int imageSidePx)
{
    std::vector<int> suspects;
    for (const Curve2d& curve : centerline.curves) {
        const bool isLong = curve.pointsPx.size() > 3 && curve.lengthPx() >= leastShareOfSuspect * imageSidePx;
        const bool hasWidth = curve.radiusPx.size() == curve.pointsPx.size();
        if (isLong && bendsEvenly(curve) && (!hasWidth || keepsItsWidth(curve.radiusPx))) {
            suspects.push_back(curve.id);
        }
    }
    return suspects;
}

}   // namespace angiopose::core