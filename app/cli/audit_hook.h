#pragma once

#include "io/sharing/audit_file.h"

#include <CLI/CLI.hpp>
#include <string>

namespace angiopose::app {

/// Adds `--audit FILE`. The files that a command is about to open are recorded in that file, or in the one that the
/// environment names. Call it after adding all commands.
void addAudit(CLI::App& app);

/// Returns the audit file of a command, or an empty string if there is none.
std::string auditPathOf(const CLI::App& app);

/// Reports on stderr that audit lines could not be written.
void reportUnaudited(const core::Message& problem);

/// Records the files that the command has written; call it after the command. The archive commands record the objects
/// that they receive themselves, since a transfer may be partial. Reports on stderr if lines cannot be written.
void auditOutcome(const CLI::App& app, int exitCode);

}   // namespace angiopose::app
