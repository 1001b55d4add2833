#pragma once

#include "core/registration/registration.h"
#include "core/support/stopwatch.h"

#include <benchmark/benchmark.h>
#include <algorithm>

namespace angiopose::benchmarks {

/// Sums the stage times of a benchmark's registrations as processor time. Results carry wall time, which other programs
/// stretch evenly over the stages.
class StageSum {
public:
    void add(const core::StageTimes& time)
    {
        wall_ = {wall_.targetMs + time.targetMs, wall_.searchMs + time.searchMs, wall_.solveMs + time.solveMs,
                 wall_.totalMs + time.totalMs};
    }

    double solveMs() const { return wall_.solveMs * share(); }   ///< total of all registrations so far

    void report(benchmark::State& state) const
    {
        const auto mean = benchmark::Counter::kAvgIterations;
        state.counters["target_ms"] = benchmark::Counter(wall_.targetMs * share(), mean);
        state.counters["search_ms"] = benchmark::Counter(wall_.searchMs * share(), mean);
        state.counters["solve_ms"] = benchmark::Counter(solveMs(), mean);
    }

private:
    double share() const { return wall_.totalMs > 0.0 ? std::min(1.0, processor_.elapsedMs() / wall_.totalMs) : 1.0; }

    core::StageTimes wall_;
    core::ThreadStopwatch processor_;
};

}   // namespace angiopose::benchmarks
