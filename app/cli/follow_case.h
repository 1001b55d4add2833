#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

namespace angiopose::app {

/// The shown run as the case knows it followed; where it does not know all of its frames they are followed now, with a
/// progress line.
core::Status followForCommand(core::Case& session);

}   // namespace angiopose::app
