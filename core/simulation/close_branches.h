#pragma once

#include "core/simulation/grow_tree.h"

#include <vector>

namespace angiopose::core {

/// Which branches still carry blood when `missingShare` of them do not: one flag per branch. Vessels close from their
/// ends, thin ones twice as often, so that no filled branch hangs on an empty one; the trunk stays open.
std::vector<bool> drawFilledBranches(const GrownTree& grown, double missingShare, CounterRandom& random);

}   // namespace angiopose::core