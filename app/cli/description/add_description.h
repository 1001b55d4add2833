#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds `description man|bash|zsh|fish`, which prints the man page or a shell's completion from the commands that `app`
/// has when it runs. It is for building packages: no help names it.
void addDescription(CLI::App& app, int& exitCode);

}   // namespace angiopose::app
