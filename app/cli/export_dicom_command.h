#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds the command that writes DICOM objects of a case.
void addExportDicom(CLI::App& app, int& exitCode);

}   // namespace angiopose::app
