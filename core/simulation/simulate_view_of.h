#pragma once

#include "core/simulation/grow_tree.h"

namespace angiopose::core {

/// simulateView of a tree that is there already. `extentMm` decides the field of view, as that of a grown tree does.
SimulatedCase simulateViewOf(const GrownTree& grown, double extentMm, std::uint64_t viewSeed,
                             const DsaOptions& dsa = {});

}   // namespace angiopose::core
