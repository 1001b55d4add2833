#pragma once

#include "core/evaluation/protocols/protocol.h"
#include "core/evaluation/trial/contestant.h"
#include "core/evaluation/trial/run_record.h"

namespace angiopose::core {

/// A part of the work that another machine may share: trials whose number leaves `index` when divided by `count`.
struct Shard {
    std::uint64_t index = 0;
    std::uint64_t count = 1;
};

struct ExperimentPlan {
    const Protocol* protocol = nullptr;
    std::vector<std::size_t> conditions;   ///< indices into the protocol's
    std::vector<Contestant> contestants;
    std::uint64_t trials = 0;   ///< of each condition, over all shards
    std::uint64_t seed = 1;
    Shard shard;
    int threads = 1;   ///< changes the time only, never the numbers
};

/// Called from the working threads, one at a time, after each trial; its answer Stop ends the experiment soon.
using ExperimentObserver = std::function<Verdict(std::uint64_t doneTrials, std::uint64_t allTrials)>;

struct Experiment {
    RunSet runs;   ///< of the trials that every method has finished
    bool wasStopped = false;
};

/// Runs every method on every trial of the shard. Numbers depend on protocol, seed, condition, trial and method alone.
Experiment runExperiment(const ExperimentPlan& plan, const ExperimentObserver& observe = {});

/// Brings the runs of shards (same protocol and seed) together as if one process had run them all; also adds methods
/// or conditions that ran apart. Fails when they do not belong together or two disagree about one run.
Result<RunSet> merged(const std::vector<RunSet>& parts);

}   // namespace angiopose::core