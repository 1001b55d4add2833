#pragma once

#include "app/cli/commands.h"
#include "core/support/result.h"
#include "core/workflow/register_case.h"

#include <string>

namespace angiopose::app {

/// Applies the arguments to the case; fails with a usage error if the arguments are inconsistent.
core::Status applyArguments(core::Case& session, const RegisterArguments& arguments);

/// Runs core::registerCase on all views with a progress line labeled `label`. Ctrl+C keeps the best pose.
core::Result<core::RegisteredCase> registerForCommand(core::Case session, const std::string& label,
                                                      core::RegistrationPlan plan = {});

/// Registers without a progress line, for several registrations at once.
core::Result<core::RegisteredCase> registerWithoutProgress(core::Case session, core::RegistrationPlan plan = {});

/// Tracks the vessels through the shown run and shows a progress line. Does nothing if the case already has tracked
/// poses for all frames.
core::Status trackForCommand(core::Case& session);

}   // namespace angiopose::app
