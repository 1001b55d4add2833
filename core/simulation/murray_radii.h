#pragma once

#include "core/simulation/grow_tree.h"

namespace angiopose::core {

/// Computes the radii of every branch from its flow: r ∝ Q^(1/3) (Murray 1926), with `rootRadiusMm` at the inlet. Each
/// branch supplies tissue at its tip and along its length, so it tapers gently between its children.
void assignMurrayRadii(GrownTree& grown, double rootRadiusMm);

}   // namespace angiopose::core
