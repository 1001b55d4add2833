#pragma once

#include "core/registration/deformable/deformation_fit.h"

namespace angiopose::core {

/// By how much a bent tree explains the rows of a fit better than a rigid one, as log evidence (ALGORITHMS §11.4). The
/// rigid tree may have noise of its own, as large as suits it.
double logEvidenceGain(const DeformationProblem& problem, const DeformationFit& fit);

}   // namespace angiopose::core
