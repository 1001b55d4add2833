#pragma once

#include "core/case/view.h"

namespace angiopose::app {

/// Source of a pose: the registration whose result belongs to the shown frame, an earlier registration or one in
/// another frame, or no registration.
enum class FoundBy { ItsRun, AnEarlierRun, NoRun };

/// Adds the knowledge of the registration that found the pose of `view` to `judged`, an evaluation of that pose in the
/// shown frame: alternatives, stop reason, duration, unopacified branches. Of an earlier registration only low
/// confidence carries over, so an unreliable pose never becomes reliable.
FoundBy takeWordOfRun(core::RegistrationResult& judged, const core::View& view);

}   // namespace angiopose::app
