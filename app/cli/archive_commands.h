#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds `archive` with its own commands; each sets `exitCode` when it runs.
void addArchive(CLI::App& app, int& exitCode);

}   // namespace angiopose::app
