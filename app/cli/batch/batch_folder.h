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

/// Outcomes in the order of the manifest's rows; empty where unknown.
using BatchOutcomes = std::vector<std::optional<BatchOutcome>>;

/// Reads the stored outcomes in a results folder that match these rows and common settings.
BatchOutcomes readOutcomes(const std::string& folder, const std::vector<io::BatchEntry>& entries,
                           const io::CaseSettings& common);

/// Reads the stored outcomes in several folders, whatever their common settings. Fails if the folders differ in these
/// settings, and names two that do.
core::Result<BatchOutcomes> mergeOutcomes(const std::vector<std::string>& folders,
                                          const std::vector<io::BatchEntry>& entries);

bool areComplete(const BatchOutcomes& outcomes);

enum class MissingOutcomes { LeftOut, Reported };

/// Writes summary.csv and times.csv for the rows of a shard, or summary-I-of-N.csv and times-I-of-N.csv if there are
/// several shards.
core::Status writeTables(const std::string& folder, const std::vector<io::BatchEntry>& entries,
                         const BatchOutcomes& outcomes, const core::Shard& shard, MissingOutcomes missing);

}   // namespace angiopose::app
