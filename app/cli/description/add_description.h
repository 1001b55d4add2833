#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds `description man|bash|zsh|fish`, which prints the man page or a shell completion generated from the commands
/// `app` has when it runs. It serves package builds and is not listed in the help.
void addDescription(CLI::App& app, int& exitCode);

}   // namespace angiopose::app
