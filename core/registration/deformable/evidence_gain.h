#pragma once

#include "core/registration/deformable/deformation_fit.h"

namespace angiopose::core {

/// Returns the log evidence of a deformed over a rigid tree for the rows of a fit (ALGORITHMS §11.4). The rigid tree
/// gets its own best-fitting noise level.
double logEvidenceGain(const DeformationProblem& problem, const DeformationFit& fit);

}   // namespace angiopose::core
