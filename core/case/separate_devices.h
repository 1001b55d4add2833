#pragma once

#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// The curves of one frame, separated by the user into vessels and devices.
struct SeparatedCurves {
    Centerline2d vessels;
    Centerline2d devices;   ///< catheters and guidewires; the target of the method `wire`
};

/// Splits `curves` into vessels and devices (the curves with `deviceIds`), each in the original order. Ids that match
/// no curve are ignored.
SeparatedCurves separateDevices(const Centerline2d& curves, const std::vector<int>& deviceIds);

/// Returns all curves: the vessels, then the devices.
Centerline2d allCurves(const SeparatedCurves& separated);

/// Returns the device ids after an edit: the remaining devices and the segments split off from a device.
std::vector<int> devicesAfterEdit(const SeparatedCurves& before, const Centerline2d& edited);

std::vector<int> curveIds(const Centerline2d& curves);

}   // namespace angiopose::core
