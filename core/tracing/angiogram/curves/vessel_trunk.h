#pragma once

#include "core/vessel/centerline2d.h"

#include <optional>

namespace angiopose::core {

/// Id of the widest curve that at least two others branch from: the trunk of the vessels. Devices have no branches, and
/// vessels that only cross do not count. Nothing if curves have no radii or none has branches.
std::optional<int> widestTrunk(const Centerline2d& centerline);

}   // namespace angiopose::core
