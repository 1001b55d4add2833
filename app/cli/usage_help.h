#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace angiopose::app {

/// `help` and `help COMMAND` as the options they stand for; anything else as it is. For CLI::App::parse: last one
/// first.
std::vector<std::string> asOptions(std::vector<std::string> arguments);

/// What is wrong with a command line, what was perhaps meant, and where help is. For CLI::App::failure_message.
std::string usageHelp(const CLI::App* app, const CLI::Error& error);

}   // namespace angiopose::app