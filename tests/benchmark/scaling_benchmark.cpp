// Measures how the time of `angiopose` and its stages grows with the number of points (200 … 200 000, used without
// resampling) and with the image size, the cost per point of an iteration, and how often the iterations allocate
// memory.

#include "core/registration/registration.h"
#include "core/simulation/phantom.h"
#include "core/simulation/simulated_case.h"
#include "tests/benchmark/allocation_count.h"
#include "tests/benchmark/stage_sum.h"

#include <benchmark/benchmark.h>
#include <algorithm>
#include <string_view>

using namespace angiopose;

namespace {

using namespace benchmarks;

constexpr std::uint64_t treeSeed = 1000;

core::RegistrationInput makeInput(int points, int imageSizePx)
{
    const core::Phantom phantom = core::makePhantom(treeSeed, points, imageSizePx);
    core::CounterRandom random(7);
    core::RegistrationInput input;
    input.tree = phantom.tree;
    input.target = phantom.exactTarget;
    input.camera = phantom.camera;
    input.initialCameraFromPatient = core::perturbAboutCentroid(
        phantom.trueCameraFromPatient, core::centroidInPatient(phantom.tree), 2.0, 5.0, random);
    return input;
}

/// Counts allocations between two reports of one stage, which is the cost of an iteration and its report, and those
/// between the last iteration and the final report, which is the cost of finishing a registration.
class AllocationsByStep {
public:
    core::ObserverDecision operator()(const core::IterationReport& report)
    {
        const std::uint64_t now = allocationsOfThisThread();
        if (report.progress >= 1.0) {
            closing_ = now - lastCount_;
        } else if (report.stage == lastStage_) {
            steps_.push_back(now - lastCount_);
        }
        lastStage_ = report.stage;
        lastCount_ = allocationsOfThisThread();   // excludes the allocations of the line above
        return core::ObserverDecision::Continue;
    }
    double median() const
    {
        std::vector<std::uint64_t> sorted = steps_;
        std::sort(sorted.begin(), sorted.end());
        return sorted.empty() ? 0.0 : static_cast<double>(sorted[sorted.size() / 2]);
    }
    double most() const
    {
        return steps_.empty() ? 0.0 : static_cast<double>(*std::max_element(steps_.begin(), steps_.end()));
    }

    double closing() const { return static_cast<double>(closing_); }

private:
    std::vector<std::uint64_t> steps_;
    std::uint64_t closing_ = 0;
    std::string_view lastStage_;
    std::uint64_t lastCount_ = 0;
};

void run(benchmark::State& state, const std::string& method, const core::RegistrationInput& input)
{
    core::RegistrationOptions options;
    options.method = method;
    options.resample = false;
    StageSum stages;
    double iterations = 0.0;
    AllocationsByStep allocations;
    while (state.KeepRunning()) {
        const auto result = core::registerVessels(input, options, std::ref(allocations));
        if (!result) {
            state.SkipWithError(result.error().message.text().c_str());
            return;
        }
        stages.add(result.value().time);
        iterations += result.value().iterations;
    }
    stages.report(state);
    state.counters["steps"] = benchmark::Counter(iterations, benchmark::Counter::kAvgIterations);
    state.counters["ns/point/step"] =
        1e6 * stages.solveMs() / std::max(1.0, iterations) / static_cast<double>(input.tree.pointCount());
    state.counters["allocs/step"] = allocations.median();
    state.counters["most"] = allocations.most();
    state.counters["closing"] = allocations.closing();
}

void byPoints(benchmark::State& state, const std::string& method)
{
    run(state, method, makeInput(static_cast<int>(state.range(0)), 512));
    state.SetComplexityN(state.range(0));
}

void byImage(benchmark::State& state, const std::string& method)
{
    run(state, method, makeInput(2000, static_cast<int>(state.range(0))));
}

BENCHMARK_CAPTURE(byPoints, angiopose, std::string("angiopose"))
    ->RangeMultiplier(10)
    ->Range(200, 200000)
    ->Arg(50000)
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(byPoints, assembled_icp, std::string("assembled-icp"))
    ->RangeMultiplier(10)
    ->Range(200, 20000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(byImage, angiopose, std::string("angiopose"))
    ->RangeMultiplier(2)
    ->Range(256, 2048)
    ->Unit(benchmark::kMillisecond);

}   // namespace

BENCHMARK_MAIN();
