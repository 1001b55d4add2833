#pragma once

#include "core/vessel/centerline2d.h"

#include <optional>

namespace angiopose::core {

/// The id of the widest curve that two others or more leave: the trunk of the vessels. Devices have no branches, and
/// vessels that only cross do not count. Nothing where curves have no radii, or none branches.
std::optional<int> widestTrunk(const Centerline2d& centerline);

}   // namespace angiopose::core
