#pragma once

#include "core/simulation/grow_tree.h"

namespace angiopose::core {

/// Fills in every branch's radii from the flow it carries: r ∝ Q^(1/3) (Murray 1926), `rootRadiusMm` at the inlet.
/// Each branch feeds tissue at its tip and along its way, so that it tapers gently between its children.
void assignMurrayRadii(GrownTree& grown, double rootRadiusMm);

}   // namespace angiopose::core