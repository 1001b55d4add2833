#pragma once

#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// The curves of a frame as the user tells them apart.
struct CurvesApart {
    Centerline2d vessels;
    Centerline2d devices;   ///< catheters and wires: no vessels, and the path of the method `wire`
};

/// `curves` taken apart: those of the ids are devices, each in its order. Ids of no curve are passed over.
CurvesApart takenApart(const Centerline2d& curves, const std::vector<int>& deviceIds);

/// The vessels, then the devices.
Centerline2d together(const CurvesApart& apart);

/// Ids of the devices among curves that were edited: those that are devices still, and what was cut off one.
std::vector<int> devicesAfterEdit(const CurvesApart& before, const Centerline2d& edited);

std::vector<int> idsOf(const Centerline2d& curves);

}   // namespace angiopose::core
