#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds the commands that work on cases; each sets `exitCode` when it runs.
void addRegister(CLI::App& app, int& exitCode);
void addTrack(CLI::App& app, int& exitCode);
void addProject(CLI::App& app, int& exitCode);
void addMovie(CLI::App& app, int& exitCode);
void addAngles(CLI::App& app, int& exitCode);
void addMeasure(CLI::App& app, int& exitCode);
void addBatch(CLI::App& app, int& exitCode);
/// Internal command with which `batch` starts its workers.
void addBatchWorker(CLI::App& app, int& exitCode);

}   // namespace angiopose::app