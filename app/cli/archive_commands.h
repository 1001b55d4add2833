#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds `archive` with its subcommands; each sets `exitCode` when it runs.
void addArchive(CLI::App& app, int& exitCode);

}   // namespace angiopose::app
