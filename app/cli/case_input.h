#pragma once

#include "app/cli/commands.h"
#include "app/cli/open_together.h"
#include "core/case/case.h"
#include "core/support/result.h"

#include <optional>
#include <string>

namespace angiopose::app {

/// Loads a case, prints its warnings, and moves it to `frame` where one is given.
core::Result<core::Case> loadCaseForCommand(const std::string& path, std::optional<int> frame);

/// Likewise of what a result was found from: as the registration began with it, or as it left it.
enum class ResultStage { Asked, Found };
core::Result<core::Case> loadResultForCommand(const FromResult& from, ResultStage stage, std::optional<int> frame);

/// Likewise of vessels, or a scan in which they are traced, and an angiogram.
core::Result<core::Case> loadPairForCommand(const InputPair& pair, std::optional<int> frame);

/// The case moved to `frame`, where one is given; fails naming `path` where its run has no such frame.
core::Result<core::Case> atFrame(core::Case session, std::optional<int> frame, const std::string& path);

}   // namespace angiopose::app