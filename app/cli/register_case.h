#pragma once

#include "app/cli/commands.h"
#include "core/support/result.h"
#include "core/workflow/register_case.h"

#include <string>

namespace angiopose::app {

/// Overrides what the arguments name; fails when they make no sense (wrong usage).
core::Status applyArguments(core::Case& session, const RegisterArguments& arguments);

/// core::registerCase of all views with a progress line of that label. Ctrl+C keeps the best pose.
core::Result<core::RegisteredCase> registerForCommand(core::Case session, const std::string& label,
                                                      core::RegistrationPlan plan = {});

/// The same without a progress line, where several cases run at once.
core::Result<core::RegisteredCase> registerQuietly(core::Case session, core::RegistrationPlan plan = {});

}   // namespace angiopose::app
