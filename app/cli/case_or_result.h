#pragma once

#include "app/cli/commands.h"

#include <CLI/CLI.hpp>

#include <string>

namespace angiopose::app {

/// CASE, or --from RESULT with --inputs, of a command that takes either.
void addCaseOrResult(CLI::App* command, std::string& casePath, FromResult& from);

/// Wrong usage (CLI::RequiredError) where neither is given.
void needCaseOrResult(const std::string& casePath, const FromResult& from);

}   // namespace angiopose::app
