#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

namespace angiopose::app {

/// Tracks the vessels through the displayed run and shows a progress line. Does nothing if the case already has tracked
/// poses for all frames.
core::Status trackForCommand(core::Case& session);

}   // namespace angiopose::app
