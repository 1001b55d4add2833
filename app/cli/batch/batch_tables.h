#pragma once

#include "app/cli/batch/batch_outcome.h"
#include "io/case/batch_manifest.h"

#include <string>

namespace angiopose::app {

// Tables of a batch; texts are quoted according to RFC 4180.

/// Results, which are reproducible: the header row and the row of one case; `outcome` null: the outcome is missing.
std::string summaryHeader();
std::string summaryRow(const io::BatchEntry& entry, const BatchOutcome* outcome);

/// Times.
std::string timesHeader();
std::string timesRow(const io::BatchEntry& entry, const BatchOutcome& outcome);

}   // namespace angiopose::app
