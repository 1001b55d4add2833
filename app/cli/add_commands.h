#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

// Each function adds one command with its subcommands; when the command runs, it sets `exitCode`.

void addAngles(CLI::App& app, int& exitCode);
void addArchive(CLI::App& app, int& exitCode);
void addBatch(CLI::App& app, int& exitCode);
void addConvert(CLI::App& app, int& exitCode);
void addEvaluate(CLI::App& app, int& exitCode);
void addExportDicom(CLI::App& app, int& exitCode);
void addInfo(CLI::App& app, int& exitCode);
void addMeasure(CLI::App& app, int& exitCode);
void addMovie(CLI::App& app, int& exitCode);
void addPack(CLI::App& app, int& exitCode);
void addProject(CLI::App& app, int& exitCode);
void addRegister(CLI::App& app, int& exitCode);
void addSchema(CLI::App& app, int& exitCode);
void addSimulate(CLI::App& app, int& exitCode);
void addStudies(CLI::App& app, int& exitCode);
void addSupportBundle(CLI::App& app, int& exitCode);
void addTraceAngiogram(CLI::App& app, int& exitCode);
void addTraceVessel(CLI::App& app, int& exitCode);
void addTrack(CLI::App& app, int& exitCode);
void addValidate(CLI::App& app, int& exitCode);

/// Adds `report`, which runs the GUI program to write the report.
void addReport(CLI::App& app, int& exitCode);

/// Adds `thumbnail`, which file managers run.
void addThumbnail(CLI::App& app, int& exitCode);

/// Adds the internal command with which `batch` starts its workers.
void addBatchWorker(CLI::App& app, int& exitCode);

/// Adds `description man|bash|zsh|fish`, which prints the man page or a shell completion generated from the commands
/// that `app` has when it runs. Package builds use this command; the help does not list it.
void addDescription(CLI::App& app, int& exitCode);

}   // namespace angiopose::app
