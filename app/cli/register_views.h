#pragma once

#include "app/cli/commands.h"
#include "core/case/case.h"

#include <string>

namespace angiopose::app {

/// Registers a case together with its other views; writes result.json, pose.tfm and overlay.png of each (the first
/// in the output folder, the others in view-2, view-3, …) and joint.json about all. Returns the exit code.
int registerViewsOf(const core::Case& first, const RegisterArguments& arguments, const std::string& folder);

}   // namespace angiopose::app