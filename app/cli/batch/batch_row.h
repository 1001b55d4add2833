#pragma once

#include "app/cli/batch/batch_job.h"
#include "app/cli/batch/batch_outcome.h"

namespace angiopose::app {

/// Creates the outcome of a row whose worker ended early, and removes the files of that row.
BatchOutcome makeAbandonedOutcome(const BatchJob& job, const std::string& status, const core::Message& reason);

}   // namespace angiopose::app
