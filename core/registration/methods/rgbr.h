#pragma once

#include "core/registration/method.h"

namespace angiopose::core {

/// Finds edges of the image along the normals of the vessel walls, chooses a pose by RANSAC with a gradient-matching
/// score, and repeats with a shorter reach (ALGORITHMS §3.8). Source: Markelj et al. 2008.
MethodSolution solveRgbr(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress);

}   // namespace angiopose::core