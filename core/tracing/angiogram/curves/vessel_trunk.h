#pragma once

#include "core/vessel/centerline2d.h"

#include <optional>

namespace angiopose::core {

/// Returns the id of the vessel trunk: the widest curve with at least two branches. Devices have no branches, and
/// vessels that merely cross do not count. Returns nullopt if no curve has radii and branches.
std::optional<int> findWidestTrunk(const Centerline2d& centerline);

}   // namespace angiopose::core
