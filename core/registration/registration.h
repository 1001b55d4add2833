#pragma once

#include "core/registration/methods/method_info.h"
#include "core/registration/problem/registration_result.h"

namespace angiopose::core {

/// Finds the pose that lays the projected tree onto the traced angiogram with the method `options.method`.
/// Fails only on unusable input, naming it; running out of iterations or a stop is a result that keeps the best pose.
/// Deterministic: the same input gives the same bits. `observe` runs on the calling thread after each iteration.
Result<RegistrationResult> registerVessels(const RegistrationInput& input, const RegistrationOptions& options = {},
                                           const IterationObserver& observe = {});

/// Judges a pose without moving it: metrics, per-branch residuals, covariance, warnings.
/// Also what the window shows while the user nudges. `timing` fields stay zero.
Result<RegistrationResult> evaluatePose(const RegistrationInput& input, const RigidTransform& cameraFromPatient);

/// "converged", "iteration limit", "no improvement", "stopped by the user".
std::string_view toText(StopReason reason);

}   // namespace angiopose::core