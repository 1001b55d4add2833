#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds `pack`; sets `exitCode` when it runs.
void addPack(CLI::App& app, int& exitCode);

}   // namespace angiopose::app
