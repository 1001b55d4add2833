#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds `report`, which starts the window's program to write one; it sets `exitCode` when it does.
void addReport(CLI::App& app, int& exitCode);

}   // namespace angiopose::app
