#pragma once

#include "core/registration/wire/follow_wire.h"

namespace angiopose::core {

/// Replaces the assessment from vessels with one from a wire: distances along its path, a covariance that includes the
/// uncertainty of the path, confidence, messages and the ranked paths.
void judgeByWire(const RegistrationProblem& problem, const WireFinding& finding, RegistrationResult& result);

}   // namespace angiopose::core
