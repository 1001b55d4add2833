#pragma once

#include "core/registration/methods/method_info.h"
#include "core/registration/problem/registration_result.h"

namespace angiopose::core {

/// Finds the pose that aligns the projected tree with the traced angiogram, using the method `options.method`. Fails
/// only on unusable input, with a message that names the problem; if the iterations run out or the user stops, returns
/// the best pose so far. Deterministic: the same input gives a bitwise identical result. Calls `observe` on the calling
/// thread after each iteration.
Result<RegistrationResult> registerVessels(const RegistrationInput& input, const RegistrationOptions& options = {},
                                           const IterationObserver& observe = {});

/// Assesses a pose without changing it: metrics, residuals per branch, covariance, warnings. Also used while the user
/// nudges the pose. The times in the result keep their defaults.
Result<RegistrationResult> evaluatePose(const RegistrationInput& input, const RigidTransform& cameraFromPatient);

/// Returns "converged", "iteration limit", "no improvement" or "stopped by the user".
std::string_view toText(StopReason reason);

}   // namespace angiopose::core
