#pragma once

#include "io/sharing/audit_file.h"

#include <CLI/CLI.hpp>
#include <string>

namespace angiopose::app {

/// Adds `--audit FILE` and records the files a command is about to open in that file, or in the one named by the
/// environment. Call it after all commands have been added.
void addAudit(CLI::App& app);

/// Returns the audit file of a command; empty: no audit.
std::string auditPathOf(const CLI::App& app);

/// Reports on stderr that audit lines could not be written.
void tellUnaudited(const core::Message& problem);

/// Records the files that the command wrote; call it after the command. The archive commands record what they receive,
/// since a transfer may be partial. Lines that cannot be written are reported on stderr.
void auditOutcome(const CLI::App& app, int exitCode);

}   // namespace angiopose::app
