#pragma once

#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"

#include <cstddef>

namespace angiopose::core {

/// A side branch that leaves `parent` at its point `takeoff` and is thinner; id and name are the caller's.
VesselBranch growSideBranch(const VesselBranch& parent, std::size_t takeoff, CounterRandom& random);

/// A catheter that comes from outside the field and ends where the trunk begins.
VesselBranch layCatheter(const VesselBranch& trunk, CounterRandom& random);

}   // namespace angiopose::core