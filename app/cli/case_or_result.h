#pragma once

#include "app/cli/commands.h"

#include <CLI/CLI.hpp>

#include <string>

namespace angiopose::app {

/// Adds CASE, or --from RESULT with --inputs, to a command that accepts either.
void addCaseOrResult(CLI::App* command, std::string& casePath, ResultSource& from);

/// Throws CLI::RequiredError if neither is given.
void requireCaseOrResult(const std::string& casePath, const ResultSource& from);

}   // namespace angiopose::app
