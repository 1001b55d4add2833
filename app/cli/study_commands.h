#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds the commands for experiments with known ground truth; each sets `exitCode` when it runs.
void addSimulate(CLI::App& app, int& exitCode);
void addEvaluate(CLI::App& app, int& exitCode);

}   // namespace angiopose::app