#include "core/tracing/angiogram/curves/devices_from_edge.h"

#include "core/tracing/angiogram/curves/field_edge.h"
#include "core/tracing/angiogram/curves/suspect_curves.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double minFractionOfField = 0.2;   // minimum device length, relative to the frame's longer side
constexpr double minDevicePx = 60.0;   // minimum device length; shorter vessel segments have equally uniform curvature
constexpr double minFractionOfCurve = 0.5;
constexpr std::size_t stepPoints = 4;

Curve2d initialPart(const Curve2d& curve, std::size_t count)
{
    const auto points = static_cast<std::ptrdiff_t>(count);
    Curve2d part{curve.id, {curve.pointsPx.begin(), curve.pointsPx.begin() + points}, {}};
    if (curve.radiusPx.size() == curve.pointsPx.size()) {
        part.radiusPx = {curve.radiusPx.begin(), curve.radiusPx.begin() + points};
    }
    return part;
}

bool startsLikeDevice(const Curve2d& curve, double minLengthPx)
{
    const double minPartPx = std::max(minLengthPx, minFractionOfCurve * curve.lengthPx());
    for (std::size_t count = stepPoints; count <= curve.pointsPx.size(); count += stepPoints) {
        const Curve2d part = initialPart(curve, count);
        if (part.lengthPx() >= minPartPx && isDeviceLike(part)) {
            return true;
        }
    }
    return false;
}

Curve2d reversed(Curve2d curve)
{
    std::ranges::reverse(curve.pointsPx);
    std::ranges::reverse(curve.radiusPx);
    return curve;
}

}   // namespace

std::vector<int> findDevicesFromEdge(const Centerline2d& centerline, const Mask2d& field)
{
    const double minLengthPx = std::max(minDevicePx, minFractionOfField * std::max(field.width, field.height));
    std::vector<int> devices;
    for (const Curve2d& curve : centerline.curves) {
        const auto entersField = [&](const Curve2d& from) {
            return !from.pointsPx.empty() && isAtFieldEdge(from.pointsPx.front(), field) &&
                   startsLikeDevice(from, minLengthPx);
        };
        if (entersField(curve) || entersField(reversed(curve))) {
            devices.push_back(curve.id);
        }
    }
    return devices;
}

}   // namespace angiopose::core
