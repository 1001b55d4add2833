#pragma once

#include "core/registration/deformable/deformation_fit.h"

namespace angiopose::core {

/// Log evidence of a deformed tree over a rigid one for the rows of a fit (ALGORITHMS §11.4). The rigid tree may use
/// its own best-fitting noise.
double logEvidenceGain(const DeformationProblem& problem, const DeformationFit& fit);

}   // namespace angiopose::core
