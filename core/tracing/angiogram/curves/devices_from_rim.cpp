#include "core/tracing/angiogram/curves/devices_from_rim.h"

#include "core/tracing/angiogram/curves/field_rim.h"
#include "core/tracing/angiogram/curves/suspect_curves.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double minShareOfField = 0.2;   // minimum device length, relative to the frame's longer side
constexpr double minDevicePx = 60.0;   // minimum device length; shorter vessel segments have equally uniform curvature
constexpr double minShareOfWhole = 0.5;
constexpr std::size_t stepPoints = 4;

Curve2d beginningOf(const Curve2d& curve, std::size_t count)
{
    const auto points = static_cast<std::ptrdiff_t>(count);
    Curve2d part{curve.id, {curve.pointsPx.begin(), curve.pointsPx.begin() + points}, {}};
    if (curve.radiusPx.size() == curve.pointsPx.size()) {
        part.radiusPx = {curve.radiusPx.begin(), curve.radiusPx.begin() + points};
    }
    return part;
}

bool beginsLikeDevice(const Curve2d& curve, double minLengthPx)
{
    const double least = std::max(minLengthPx, minShareOfWhole * curve.lengthPx());
    for (std::size_t count = stepPoints; count <= curve.pointsPx.size(); count += stepPoints) {
        const Curve2d part = beginningOf(curve, count);
        if (part.lengthPx() >= least && runsLikeDevice(part)) {
            return true;
        }
    }
    return false;
}

Curve2d turned(Curve2d curve)
{
    std::ranges::reverse(curve.pointsPx);
    std::ranges::reverse(curve.radiusPx);
    return curve;
}

}   // namespace

std::vector<int> devicesFromRim(const Centerline2d& centerline, const Mask2d& field)
{
    const double minLengthPx = std::max(minDevicePx, minShareOfField * std::max(field.width, field.height));
    std::vector<int> devices;
    for (const Curve2d& curve : centerline.curves) {
        const auto comesFromRim = [&](const Curve2d& from) {
            return !from.pointsPx.empty() && isAtRim(from.pointsPx.front(), field) &&
                   beginsLikeDevice(from, minLengthPx);
        };
        if (comesFromRim(curve) || comesFromRim(turned(curve))) {
            devices.push_back(curve.id);
        }
    }
    return devices;
}

}   // namespace angiopose::core
