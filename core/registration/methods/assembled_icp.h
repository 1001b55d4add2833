#pragma once

#include "core/registration/method.h"

namespace angiopose::core {

/// What a good engineer builds in an afternoon from library parts: nearest neighbours by nanoflann, then OpenCV's SQPNP
/// (Terzakis, Lourakis 2020) on the pairs, repeated until the pairs stay (ALGORITHMS §3.14). With the whole tree in the
/// image and a start close by it is quick and exact already: what other methods must beat.
MethodSolution solveAssembledIcp(const RegistrationProblem& problem, const RegistrationOptions& options,
                                 ProgressLog& progress);

}   // namespace angiopose::core