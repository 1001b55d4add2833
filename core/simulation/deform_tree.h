#pragma once

#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// Returns the tree after a smooth random deformation: a Gaussian process with a correlation length of 40 mm and the
/// given standard deviation per axis (ALGORITHMS §4.4), sampled with random Fourier features (Rahimi & Recht 2007).
VesselTree deformed(const VesselTree& tree, double standardDeviationMm, CounterRandom& random);

}   // namespace angiopose::core
