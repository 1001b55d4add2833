#pragma once

#include "io/sharing/audit_file.h"

#include <CLI/CLI.hpp>
#include <string>

namespace angiopose::app {

/// `--audit FILE`, and what goes into that file, or the one that the environment names: what a command is about to
/// open. After all commands are known.
void addAudit(CLI::App& app);

/// The audit file of a command; empty: none is wished.
std::string auditPathOf(const CLI::App& app);

/// What cannot be written to it is told on stderr.
void tellUnaudited(const core::Message& problem);

/// What the command wrote; after it. What comes from archives they note by themselves: a part of it may have come.
/// Lines that cannot be written are told on stderr.
void auditOutcome(const CLI::App& app, int exitCode);

}   // namespace angiopose::app
