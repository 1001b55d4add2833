// Time of one registration on one core: `angiopose` with its target map and search against `iterative-pnp` with
// KD-tree.

#include "core/evaluation/protocol.h"
#include "core/registration/registration.h"

#include <benchmark/benchmark.h>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

namespace {

constexpr std::size_t inputCount = 20;   ///< start poses, taken in turn

/// Built once; every method sees the same inputs.
const std::vector<core::RegistrationInput>& inputs()
{
    static const std::vector<core::RegistrationInput> all = [] {
        const core::Protocol& simulation = *core::findProtocol("simulation");
        const auto makeTrial = simulation.prepare(core::conditionsFrom(simulation, "obj-2-5").value().front(), 1);
        std::vector<core::RegistrationInput> list;
        for (std::uint64_t trial = 0; trial < inputCount; ++trial) {
            list.push_back(makeTrial(trial).input);
        }
        return list;
    }();
    return all;
}

void registerOnce(benchmark::State& state, const std::string& method)
{
    core::RegistrationOptions options;
    options.method = method;
    core::StageTimes sum;
    std::size_t next = 0;
    while (state.KeepRunning()) {
        const auto result = core::registerVessels(inputs()[next++ % inputCount], options);
        if (!result) {
            state.SkipWithError(result.error().message.c_str());
            return;
        }
        const core::StageTimes& time = result.value().time;
        sum = {sum.targetMs + time.targetMs, sum.searchMs + time.searchMs, sum.solveMs + time.solveMs, 0.0};
    }
    const auto mean = benchmark::Counter::kAvgIterations;
    state.counters["target_ms"] = benchmark::Counter(sum.targetMs, mean);
    state.counters["search_ms"] = benchmark::Counter(sum.searchMs, mean);
    state.counters["solve_ms"] = benchmark::Counter(sum.solveMs, mean);
}

/// The usual print, remembering each benchmark's median processor time, which other programs disturb least.
class MedianReporter : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& reports) override
    {
        for (const Run& run : reports) {
            if (run.aggregate_name == "median") {
                mediansMs_[run.run_name.function_name] = run.GetAdjustedCPUTime();
            }
        }
        ConsoleReporter::ReportRuns(reports);
    }
    double medianMs(const std::string& name) const
    {
        const auto found = mediansMs_.find(name);
        return found == mediansMs_.end() ? 0.0 : found->second;
    }

private:
    std::map<std::string, double> mediansMs_;
};

}   // namespace

int main(int argc, char** argv)
{
    for (const char* method : {"angiopose", "dynaweight", "iterative-pnp"}) {
        benchmark::RegisterBenchmark(method, registerOnce, std::string(method))
            ->Unit(benchmark::kMillisecond)
            ->Iterations(inputCount)
            ->Repetitions(9)
            ->ReportAggregatesOnly(true);
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    MedianReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    const double oursMs = reporter.medianMs("angiopose");
    const double theirsMs = reporter.medianMs("iterative-pnp");
    if (oursMs > 0.0 && theirsMs > 0.0) {
        std::printf(
            "\nMedian per registration: angiopose %.1f ms, iterative-pnp %.1f ms: ratio 1 : %.1f (aim: 1 : 5)\n",
            oursMs, theirsMs, theirsMs / oursMs);
    }
    return 0;
}
