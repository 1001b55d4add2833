#pragma once

#include "app/cli/batch/batch_job.h"
#include "app/cli/batch/batch_outcome.h"

namespace angiopose::app {

/// Registers one row of a batch, with all views of its case jointly, and writes the outputs of `register` into its
/// folder, the outcome last. Any failure becomes the outcome. Empty if stopped: files written so far are then not an
/// outcome.
std::optional<BatchOutcome> doRow(const BatchJob& job);

/// Creates the outcome of a row whose worker ended, and removes its files.
BatchOutcome abandonedRow(const BatchJob& job, const std::string& status, const core::Message& why);

}   // namespace angiopose::app
