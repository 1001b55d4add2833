#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <optional>
#include <string>

namespace angiopose::app {

/// Loads a case, prints its warnings, and moves it to `frame` where one is given.
core::Result<core::Case> loadCaseForCommand(const std::string& path, std::optional<int> frame);

}   // namespace angiopose::app