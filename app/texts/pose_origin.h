#pragma once

#include "core/case/view.h"

namespace angiopose::app {

/// Source of a pose: the registration whose result belongs to the shown frame, an earlier one or one in another frame,
/// or none.
enum class PoseOrigin { Registration, EarlierRegistration, None };

/// Completes `evaluation`, which assesses the pose of `view` in the shown frame, with results of the registration that
/// found the pose: alternatives, stop reason, duration, unopacified branches. From an earlier registration, only low
/// confidence carries over, so that an unreliable pose never becomes reliable.
PoseOrigin addRegistrationResult(core::RegistrationResult& evaluated, const core::View& view);

}   // namespace angiopose::app
