#pragma once

#include "core/evaluation/trial/run_record.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Writes runs.csv (byte-identical for any number of threads), times.csv and histories.csv into an existing folder.
core::Status writeRuns(const core::RunSet& runs, const std::string& folder);

/// Reads these files with exactly the written numbers; the last two may be missing. Errors name the file and the line.
core::Result<core::RunSet> readRuns(const std::string& folder);

}   // namespace angiopose::io
