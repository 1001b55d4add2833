#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace angiopose::app {

/// Translates `help` and `help COMMAND` to the equivalent options; returns other arguments unchanged. The result is in
/// reverse order, as CLI::App::parse expects it.
std::vector<std::string> helpAsOptions(std::vector<std::string> arguments);

/// Describes a usage error, suggests what may have been meant, and refers to the help. For CLI::App::failure_message.
std::string usageHelp(const CLI::App* app, const CLI::Error& error);

}   // namespace angiopose::app
