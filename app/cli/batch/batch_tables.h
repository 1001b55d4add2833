#pragma once

#include "app/cli/batch/batch_outcome.h"
#include "io/case/batch_manifest.h"

#include <string>

namespace angiopose::app {

// The tables of a batch: texts are quoted as RFC 4180 says.

/// What was found, the same in any run: the header row, and that of one case; `outcome` null: it is missing.
std::string summaryHeader();
std::string summaryRow(const io::BatchEntry& entry, const BatchOutcome* outcome);

/// What it took.
std::string timesHeader();
std::string timesRow(const io::BatchEntry& entry, const BatchOutcome& outcome);

}   // namespace angiopose::app
