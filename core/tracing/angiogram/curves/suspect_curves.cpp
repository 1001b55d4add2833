#include "core/tracing/angiogram/curves/suspect_curves.h"

#include "core/support/quantile.h"
#include "core/tracing/angiogram/curves/path_curvature.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double minSuspectFraction = 0.15;
constexpr double maxArcDeviationPx = 0.7;   // maximum RMS distance from the best-fit arc or line, for short curves
constexpr double maxArcDeviationPerLength = 0.006;   // maximum RMS distance relative to the length, for long curves
constexpr double minLoopPx = 20.0;
constexpr double maxLoopFraction = 0.6;
constexpr double maxLoopGap = 0.15;   // maximum distance between the ends, relative to the length
constexpr double maxWidthSpread = 0.3;   // maximum spread relative to the width; walls of hollow devices appear uneven
constexpr double maxTaper = 0.2;   // maximum change between the two halves, relative to the width

bool hasConstantCurvature(const Curve2d& curve)
{
    const double tolerance = std::max(maxArcDeviationPx, maxArcDeviationPerLength * curve.lengthPx());
    return deviationFromLine(curve.pointsPx) <= tolerance || deviationFromArc(curve.pointsPx) <= tolerance;
}

bool hasConstantWidth(const std::vector<double>& radii)
{
    const std::vector<double> spread = quantiles(radii, {0.16, 0.5, 0.84});
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    const double change = quantile({radii.begin(), middle}, 0.5) - quantile({middle, radii.end()}, 0.5);
    return 0.5 * (spread[2] - spread[0]) <= maxWidthSpread * spread[1] && std::abs(change) <= maxTaper * spread[1];
}

/// Returns whether a curve closes on itself, like a wire loop and unlike a single vessel.
bool isClosedLoop(const Curve2d& curve, int imageSidePx)
{
    const double length = curve.lengthPx();
    return length >= minLoopPx && length <= maxLoopFraction * imageSidePx &&
           (curve.pointsPx.front() - curve.pointsPx.back()).norm() <= maxLoopGap * length;
}

bool hasRadii(const Curve2d& curve)
{
    return curve.radiusPx.size() == curve.pointsPx.size();
}

}   // namespace

bool isDeviceLike(const Curve2d& curve)
{
    return curve.pointsPx.size() > 3 && hasConstantCurvature(curve) &&
           (!hasRadii(curve) || hasConstantWidth(curve.radiusPx));
}

std::vector<int> suspectCurves(const Centerline2d& centerline, int imageSidePx)
{
    std::vector<int> suspects;
    for (const Curve2d& curve : centerline.curves) {
        const bool isLong = curve.pointsPx.size() > 3 && curve.lengthPx() >= minSuspectFraction * imageSidePx;
        const bool isLoop = hasRadii(curve) && curve.pointsPx.size() > 3 && isClosedLoop(curve, imageSidePx) &&
                            hasConstantWidth(curve.radiusPx);
        if (isLoop || (isLong && isDeviceLike(curve))) {
            suspects.push_back(curve.id);
        }
    }
    return suspects;
}

}   // namespace angiopose::core
