#pragma once

#include "app/cli/batch/batch_outcome.h"
#include "core/evaluation/run_experiment.h"
#include "core/support/result.h"
#include "io/case/batch_manifest.h"
#include "io/case/case_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::app {

/// Outcomes of a manifest's rows, in its order; those that are not known are empty.
using BatchOutcomes = std::vector<std::optional<BatchOutcome>>;

/// What stands in a folder of results, of rows that were asked for like this.
BatchOutcomes outcomesIn(const std::string& folder, const std::vector<io::BatchEntry>& entries,
                         const io::CaseSettings& common);

/// Likewise of several folders, and however they were set in common, but all alike: else it fails, naming two.
core::Result<BatchOutcomes> mergedOutcomes(const std::vector<std::string>& folders,
                                           const std::vector<io::BatchEntry>& entries);

bool areAllThere(const BatchOutcomes& outcomes);

enum class MissingRows { LeftOut, Reported };

/// Writes summary.csv and times.csv of the rows of a shard, summary-I-of-N.csv and times-I-of-N.csv where there are
/// others.
core::Status writeTables(const std::string& folder, const std::vector<io::BatchEntry>& entries,
                         const BatchOutcomes& outcomes, const core::Shard& shard, MissingRows missing);

}   // namespace angiopose::app
