#include "core/case/separate_devices.h"

#include <algorithm>
#include <iterator>

namespace angiopose::core {
namespace {

bool hasId(const Centerline2d& curves, int id)
{
    return std::ranges::find(curves.curves, id, &Curve2d::id) != curves.curves.end();
}

bool hasPoint(const Centerline2d& curves, const Eigen::Vector2d& pointPx)
{
    return std::ranges::any_of(curves.curves, [&pointPx](const Curve2d& curve) {
        return std::ranges::find(curve.pointsPx, pointPx) != curve.pointsPx.end();
    });
}

}   // namespace

SeparatedCurves separateDevices(const Centerline2d& curves, const std::vector<int>& deviceIds)
{
    SeparatedCurves separated;
    for (const Curve2d& curve : curves.curves) {
        const bool isDevice = std::ranges::find(deviceIds, curve.id) != deviceIds.end();
        (isDevice ? separated.devices : separated.vessels).curves.push_back(curve);
    }
    return separated;
}

Centerline2d allCurves(const SeparatedCurves& separated)
{
    Centerline2d all = separated.vessels;
    all.curves.insert(all.curves.end(), separated.devices.curves.begin(), separated.devices.curves.end());
    return all;
}

std::vector<int> devicesAfterEdit(const SeparatedCurves& before, const Centerline2d& edited)
{
    std::vector<int> ids;
    for (const Curve2d& curve : edited.curves) {
        const bool isNew = !hasId(before.vessels, curve.id) && !hasId(before.devices, curve.id);
        const bool isOfDevice =
            isNew && !curve.pointsPx.empty() && hasPoint(before.devices, curve.pointsPx[curve.pointsPx.size() / 2]);
        if (hasId(before.devices, curve.id) || isOfDevice) {
            ids.push_back(curve.id);
        }
    }
    return ids;
}

std::vector<int> curveIds(const Centerline2d& curves)
{
    std::vector<int> ids;
    std::ranges::transform(curves.curves, std::back_inserter(ids), &Curve2d::id);
    return ids;
}

}   // namespace angiopose::core
