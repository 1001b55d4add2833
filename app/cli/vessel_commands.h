#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds the commands that create and change vessel inputs; each sets `exitCode` when it runs.
void addTraceVessel(CLI::App& app, int& exitCode);
void addConvert(CLI::App& app, int& exitCode);

}   // namespace angiopose::app