#pragma once

#include "app/cli/commands.h"
#include "core/case/case.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::app {

/// Overrides what the arguments name; fails when they make no sense (wrong usage).
core::Status applyArguments(core::Case& theCase, const RegisterArguments& arguments);

/// A case after its registration, and the target it was registered to.
struct RegisteredCase {
    core::Case theCase;   ///< with its result
    core::Centerline2d target;
};

/// Traces, registers with a progress line of that label, and takes over the pose. Ctrl+C keeps the best pose.
core::Result<RegisteredCase> registerCase(core::Case theCase, const std::string& label);

/// Writes result.json, pose.tfm and overlay.png; makes the folder.
core::Status writeOutputs(const RegisteredCase& registered, const std::string& folder);

}   // namespace angiopose::app