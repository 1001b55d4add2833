#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// `--audit FILE`, and what goes into that file, or the one that the environment names: what a command is about to
/// open. After all commands are known.
void addAudit(CLI::App& app);

/// What the command wrote; after it. Lines that cannot be written are told on stderr.
void auditOutcome(const CLI::App& app, int exitCode);

}   // namespace angiopose::app
