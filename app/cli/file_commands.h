#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds the commands that inspect files and angiograms; each sets `exitCode` when it runs.
void addTraceAngiogram(CLI::App& app, int& exitCode);
void addStudies(CLI::App& app, int& exitCode);
void addInfo(CLI::App& app, int& exitCode);
void addValidate(CLI::App& app, int& exitCode);
void addSchema(CLI::App& app, int& exitCode);

}   // namespace angiopose::app