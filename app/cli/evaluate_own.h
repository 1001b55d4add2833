#pragma once

#include "app/cli/commands.h"
#include "core/evaluation/own/observer_agreement.h"
#include "core/evaluation/run_experiment.h"
#include "core/support/result.h"

#include <string>
#include <vector>

namespace angiopose::app {

inline constexpr const char* defaultMethods =
    "angiopose,dynaweight:seed_noprior,dynaweight:seed_mean,iterative-pnp:seed_mean";
inline constexpr const char* ownCases = "own";   ///< experiments whose trials are files
inline constexpr const char* observerLogs = "observers";

/// Registers the cases that a manifest lists (io/evaluation/own_manifest.h), with each method that was asked for, and
/// judges every result and every pose found elsewhere by the case's truth. A case that fails is told and counts as one
/// without result. Numbers are the same for any number of threads and for shards that are merged.
core::Result<core::Experiment> runOwnCases(const EvaluateArguments& arguments);

/// The readings of all logs; fails where none is named.
core::Result<std::vector<core::ObserverReading>> observerReadings(const std::vector<std::string>& paths);

}   // namespace angiopose::app
