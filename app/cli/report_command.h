#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds `report`, which starts the window's program to write a report and sets `exitCode`.
void addReport(CLI::App& app, int& exitCode);

}   // namespace angiopose::app
