#pragma once

#include "app/cli/commands.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace angiopose::app {

/// Adds CASE, or --from RESULT with --inputs, to a command that accepts either.
void addCaseOrResult(CLI::App* command, std::string& casePath, ResultSource& from);

/// Throws CLI::RequiredError if neither is given.
void requireCaseOrResult(const std::string& casePath, const ResultSource& from);

/// Adds `--frame`, which counts from 1 as in the window and in DICOM.
CLI::Option* addFrameOption(CLI::App& command, std::optional<int>& frame, const std::string& help);

/// Lists every method ID with its summary, for the command help.
std::string methodList();

}   // namespace angiopose::app
