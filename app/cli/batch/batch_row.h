#pragma once

#include "app/cli/batch/batch_job.h"
#include "app/cli/batch/batch_outcome.h"

namespace angiopose::app {

/// Registers a row of a batch, all views of its case together, and writes what `register` writes of it into its folder,
/// the outcome last. Whatever goes wrong is the outcome. Nothing when stopped: what is there of it then is no outcome.
std::optional<BatchOutcome> doRow(const BatchJob& job);

/// Of a row that a worker did not survive; nothing of what it wrote stays.
BatchOutcome abandonedRow(const BatchJob& job, const std::string& status, const core::Message& why);

}   // namespace angiopose::app
