#pragma once

#include "core/evaluation/protocols/protocol.h"
#include "core/evaluation/trial/evaluated_method.h"
#include "core/evaluation/trial/run_record.h"

namespace angiopose::core {

/// The part of an experiment that runs on one machine: the trials whose number modulo `count` equals `index`.
struct Shard {
    std::uint64_t index = 0;
    std::uint64_t count = 1;
};

struct ExperimentPlan {
    const Protocol* protocol = nullptr;
    std::vector<std::size_t> conditions;   ///< indices into the conditions of the protocol
    std::vector<EvaluatedMethod> evaluatedMethods;
    std::uint64_t trials = 0;   ///< per condition, over all shards
    std::uint64_t seed = 1;
    Shard shard;
    int threads = 1;   ///< affects only the computation time, never the results
};

/// Called by the worker threads, one at a time, after each trial; if it returns Stop, the experiment ends soon.
using ExperimentObserver = std::function<ObserverDecision(std::uint64_t finishedTrials, std::uint64_t totalTrials)>;

struct Experiment {
    RunSet runs;   ///< runs of the trials that were completed with all methods
    bool wasStopped = false;
};

/// Runs every method on every trial of the shard. Results depend only on protocol, seed, condition, trial and method.
Experiment runExperiment(const ExperimentPlan& plan, const ExperimentObserver& observe = {});

/// Merges the runs of shards (same protocol and seed) as if one process had computed them all; also adds methods or
/// conditions that were run separately. Fails if the parts do not belong together or contradict each other.
Result<RunSet> mergeRunSets(const std::vector<RunSet>& parts);

}   // namespace angiopose::core
