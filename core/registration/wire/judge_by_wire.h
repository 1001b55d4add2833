#pragma once

#include "core/registration/wire/follow_wire.h"

namespace angiopose::core {

/// What a wire tells about a pose takes the place of what vessels would: distances along its way, the covariance in
/// doubt of the way, trust, words and the ranked ways.
void judgeByWire(const RegistrationProblem& problem, const WireFinding& finding, RegistrationResult& result);

}   // namespace angiopose::core
