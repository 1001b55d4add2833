#pragma once

#include "app/cli/commands.h"
#include "app/cli/open_pair.h"
#include "core/case/case.h"
#include "core/support/result.h"

#include <optional>
#include <string>

namespace angiopose::app {

/// Loads a case, prints its warnings, and selects `frame` if specified.
core::Result<core::Case> loadCaseForCommand(const std::string& path, std::optional<int> frame);

/// State of the case to load for a result: before registration (`Unregistered`) or after it (`Registered`).
enum class ResultState { Unregistered, Registered };
core::Result<core::Case> loadResultForCommand(const ResultSource& from, ResultState stage, std::optional<int> frame);

/// Loads an angiogram with vessels, or with a scan in which the vessels are traced; prints the warnings and selects
/// `frame` if specified.
core::Result<core::Case> loadPairForCommand(const InputPair& pair, std::optional<int> frame);

/// Selects `frame` of the case if specified; fails with `path` in the message if the run has no such frame.
core::Result<core::Case> selectFrame(core::Case session, std::optional<int> frame, const std::string& path);

}   // namespace angiopose::app
