#include "core/tracing/angiogram/curves/devices_apart.h"

#include "core/tracing/angiogram/curves/field_rim.h"
#include "core/tracing/angiogram/curves/suspect_curves.h"

#include <algorithm>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double leastShareOfDevice = 0.2;   // of the frame's longer side
constexpr std::size_t stepPoints = 4;
constexpr std::size_t leastRestPoints = 10;

Curve2d partOf(const Curve2d& curve, std::size_t from, std::size_t count)
{
    const auto first = static_cast<std::ptrdiff_t>(from);
    const auto last = static_cast<std::ptrdiff_t>(from + count);
    Curve2d part{curve.id, {curve.pointsPx.begin() + first, curve.pointsPx.begin() + last}, {}};
    if (curve.radiusPx.size() == curve.pointsPx.size()) {
        part.radiusPx = {curve.radiusPx.begin() + first, curve.radiusPx.begin() + last};
    }
    return part;
}

void turn(Curve2d& curve)
{
    std::ranges::reverse(curve.pointsPx);
    std::ranges::reverse(curve.radiusPx);
}

/// How many points from the first on run as a device does; 0 if none do, or nearly all.
std::size_t devicePoints(const Curve2d& curve, double leastLengthPx)
{
    std::size_t longest = 0;
    for (std::size_t count = stepPoints; count + leastRestPoints <= curve.pointsPx.size(); count += stepPoints) {
        const Curve2d part = partOf(curve, 0, count);
        if (part.lengthPx() >= leastLengthPx && runsLikeDevice(part)) {
            longest = count;
        }
    }
    return longest;
}

}   // namespace

std::vector<Curve2d> withDevicesApart(std::vector<Curve2d> curves, const Mask2d& field)
{
    const double leastLengthPx = leastShareOfDevice * std::max(field.width, field.height);
    std::vector<Curve2d> parts;
    for (Curve2d& curve : curves) {
        for (int end = 0; end < 2 && !curve.pointsPx.empty() && !runsLikeDevice(curve); ++end) {
            const std::size_t device = isAtRim(curve.pointsPx.front(), field) ? devicePoints(curve, leastLengthPx) : 0;
            if (device > 0) {
                parts.push_back(partOf(curve, 0, device));
                curve = partOf(curve, device - 1, curve.pointsPx.size() - device + 1);
            }
            turn(curve);
        }
        parts.push_back(std::move(curve));
    }
    for (std::size_t k = 0; k < parts.size(); ++k) {
        parts[k].id = static_cast<int>(k) + 1;
    }
    return parts;
}

}   // namespace angiopose::core
