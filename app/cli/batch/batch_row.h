#pragma once

#include "app/cli/batch/batch_job.h"
#include "app/cli/batch/batch_outcome.h"

namespace angiopose::app {

/// Registers one batch row, with all views of its case jointly, and writes the outputs of `register` into the folder of
/// the row, the outcome last. Any failure becomes the outcome. Returns an empty value if stopped; the files written so
/// far then count as no outcome.
std::optional<BatchOutcome> processRow(const BatchJob& job);

/// Creates the outcome of a row whose worker ended early, and removes the files of that row.
BatchOutcome makeAbandonedOutcome(const BatchJob& job, const std::string& status, const core::Message& why);

}   // namespace angiopose::app
