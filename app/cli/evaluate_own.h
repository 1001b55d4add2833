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
inline constexpr const char* userCasesProtocol = "own";   ///< name of the protocol whose trials are files
inline constexpr const char* observerLogs = "observers";

/// Registers the cases of a manifest (io/evaluation/cohort_manifest.h) with each requested method, and compares every
/// result and every pose of another program with the ground truth of its case. Reports a failed case, which counts as a
/// case without a result. The figures do not depend on the number of threads or on splitting into shards.
core::Result<core::Experiment> evaluateUserCases(const EvaluateArguments& arguments);

/// Reads the readings of all observer logs; fails if no log is named.
core::Result<std::vector<core::ObserverReading>> readObserverLogs(const std::vector<std::string>& paths);

}   // namespace angiopose::app
