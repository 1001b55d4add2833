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

/// Outcomes of a manifest's rows, in its order; unknown ones are empty.
using BatchOutcomes = std::vector<std::optional<BatchOutcome>>;

/// Reads the stored outcomes in a results folder that match these rows and common settings.
BatchOutcomes outcomesIn(const std::string& folder, const std::vector<io::BatchEntry>& entries,
                         const io::CaseSettings& common);

/// Reads the stored outcomes of several folders with any common settings. Fails if the folders differ in their
/// settings, and names two of them.
core::Result<BatchOutcomes> mergedOutcomes(const std::vector<std::string>& folders,
                                           const std::vector<io::BatchEntry>& entries);

bool areAllThere(const BatchOutcomes& outcomes);

enum class MissingRows { LeftOut, Reported };

/// Writes summary.csv and times.csv for the rows of a shard, or summary-I-of-N.csv and times-I-of-N.csv if there are
/// several shards.
core::Status writeTables(const std::string& folder, const std::vector<io::BatchEntry>& entries,
                         const BatchOutcomes& outcomes, const core::Shard& shard, MissingRows missing);

}   // namespace angiopose::app
