// Time of one registration on one core, 2000 points, 512 × 512, including target map, search and assessment, compared
// with OpenCV's solvers for known correspondences and with the other methods, on three targets: the tree's own
// projected points, the same curves resampled, and a simulated trace of them; and time per frame when tracking, without
// the new target map. Medians and their ratios from one execution.

#include "core/evaluation/protocols/protocol.h"
#include "core/evaluation/trial/evaluated_method.h"
#include "core/evaluation/trial/projection_error.h"
#include "core/registration/methods/method_info.h"
#include "core/support/format_number.h"
#include "core/support/quantile.h"
#include "tests/benchmark/breathing_run.h"
#include "tests/benchmark/known_partners.h"
#include "tests/benchmark/median_reporter.h"
#include "tests/benchmark/stage_sum.h"

#include <algorithm>
#include <array>
#include <cstdio>

using namespace angiopose;

namespace {

using namespace benchmarks;

constexpr std::size_t trialCount = 20;   ///< initial poses, used in turn
constexpr int repetitions = 5;

struct BenchmarkTarget {
    const char* condition;   ///< of the protocol "simulation"
    const char* title;
};
constexpr std::array targets{BenchmarkTarget{"exact-obj-2-5", "own points"}, BenchmarkTarget{"obj-2-5", "resampled"},
                             BenchmarkTarget{"degraded-obj-2-5", "degraded"}};
const std::string refineKnown = "known/solvePnPRefineLM";

struct BenchmarkAim {
    const char* other;
    double share;   ///< maximum ratio to the other's time, on degraded targets
};
constexpr std::array aims{BenchmarkAim{"known/solvePnPRefineLM", 1.5}, BenchmarkAim{"assembled-icp", 0.2}};
constexpr double trackingAim = 1.0 / 6.0;

/// Trials made once per condition, the same for every method.
const std::vector<core::Trial>& trialsOf(const std::string& condition)
{
    static std::map<std::string, std::vector<core::Trial>> made;
    std::vector<core::Trial>& trials = made[condition];
    if (trials.empty()) {
        const core::Protocol& simulation = *core::findProtocol("simulation");
        const auto maker = simulation.prepare(core::parseConditions(simulation, condition).value().front(), 1);
        for (std::uint64_t number = 0; number < trialCount; ++number) {
            trials.push_back(maker(number));
        }
    }
    return trials;
}

void registerOnce(benchmark::State& state, const std::string& method, const std::string& condition)
{
    const std::vector<core::Trial>& trials = trialsOf(condition);
    const core::EvaluatedMethod evaluatedMethod = core::parseMethod(method).value();
    const core::RegistrationOptions options = core::optionsFor(evaluatedMethod, trials.front().targetIsExact);
    StageSum stages;
    std::vector<core::RigidTransform> found(trialCount);
    std::size_t next = 0;
    while (state.KeepRunning()) {
        const std::size_t trial = next++ % trialCount;
        const auto result = core::registerVessels(trials[trial].input, options);
        if (!result) {
            state.SkipWithError(result.error().message.text().c_str());
            return;
        }
        stages.add(result.value().time);
        found[trial] = result.value().cameraFromPatient;
    }
    stages.report(state);
    std::vector<double> errorsPx;
    for (std::size_t trial = 0; trial < trialCount; ++trial) {
        const core::PosePair poses{found[trial], trials[trial].trueCameraFromPatient};
        errorsPx.push_back(core::projectionError(*trials[trial].tree, trials[trial].input.camera, poses).meanPx);
    }
    state.counters["error_px"] = core::quantile(errorsPx, 0.5);
    state.counters["worst_px"] = *std::max_element(errorsPx.begin(), errorsPx.end());
}

void solveKnown(benchmark::State& state, FoundPose (*solve)(const KnownPartners&))
{
    std::vector<KnownPartners> all;
    for (const core::Trial& trial : trialsOf(targets.front().condition)) {
        all.push_back(knownPartners(trial));
    }
    std::vector<FoundPose> found(trialCount);
    std::size_t next = 0;
    while (state.KeepRunning()) {
        const std::size_t trial = next++ % trialCount;
        found[trial] = solve(all[trial]);
    }
    double worstPx = 0.0;
    for (std::size_t trial = 0; trial < trialCount; ++trial) {
        worstPx = std::max(worstPx, meanDistancePx(all[trial], found[trial]));
    }
    state.counters["worst_px"] = worstPx;
}

void trackFrames(benchmark::State& state)
{
    const BreathingRun run = breathingRun(trialsOf(targets.front().condition).front(), trialCount);
    core::FrameTracker tracker(run.first, {});
    std::vector<core::RigidTransform> found;
    int searches = 0;
    while (state.KeepRunning()) {
        const core::TrackedFrame frame = tracker.next(run.targets[found.size()]).value();
        found.push_back(frame.cameraFromPatient);
        searches += frame.isFromSearch ? 1 : 0;
    }
    double worstPx = 0.0;
    for (std::size_t frame = 0; frame < found.size(); ++frame) {
        worstPx = std::max(worstPx, run.errorPx(found[frame], frame));
    }
    state.counters["worst_px"] = worstPx;
    state.counters["searches"] = searches;
}

/// Computes only the target maps of the same frames.
void mapFrames(benchmark::State& state)
{
    const BreathingRun run = breathingRun(trialsOf(targets.front().condition).front(), trialCount);
    std::size_t next = 0;
    while (state.KeepRunning()) {
        const core::TargetSamples target = core::sampleTarget(run.targets[next++ % trialCount], {});
        benchmark::DoNotOptimize(core::TargetLines(target, run.first.camera));
    }
}

template <class Run>
void add(const std::string& name, const Run& run)
{
    benchmark::RegisterBenchmark(name.c_str(), run)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(trialCount)
        ->Repetitions(repetitions)
        ->ReportAggregatesOnly(true);
}

std::string nameOf(const BenchmarkTarget& target, const std::string& method)
{
    return std::string(target.condition) + "/" + method;
}

void addAll()
{
    add(refineKnown, [](benchmark::State& state) { solveKnown(state, refineLm); });
    add("known/SQPNP", [](benchmark::State& state) { solveKnown(state, sqpnp); });
    add("tracking/frame", trackFrames);
    add("tracking/map", mapFrames);
    for (const BenchmarkTarget& target : targets) {
        for (const core::MethodInfo& info : core::methodInfos()) {
            add(nameOf(target, std::string(info.id)), [method = std::string(info.id), target](benchmark::State& state) {
                registerOnce(state, method, target.condition);
            });
        }
    }
}

/// "1.23", or "–" if one of the two did not run.
std::string ratioText(double ms, double otherMs)
{
    return ms > 0.0 && otherMs > 0.0 ? core::fixedText(ms / otherMs, 2) : "–";
}

/// Prints one row of the ratios of angiopose's times to another method's, by target.
void printRatios(const MedianReporter& reporter, const std::string& other, bool knowsPartners)
{
    std::printf("%-24s", other.c_str());
    for (const BenchmarkTarget& target : targets) {
        const double theirsMs = reporter.medianMs(knowsPartners ? other : nameOf(target, other));
        std::printf("  %12s", ratioText(reporter.medianMs(nameOf(target, "angiopose")), theirsMs).c_str());
    }
    const auto aim = std::ranges::find_if(aims, [&](const BenchmarkAim& row) { return row.other == other; });
    std::printf("%s\n", aim != aims.end() ? ("  ≤ " + core::fixedText(aim->share, 2)).c_str() : "");
}

void printTimes(const MedianReporter& reporter)
{
    std::printf("\nMedian processor time of one registration, ms\n%-24s", "");
    for (const BenchmarkTarget& target : targets) {
        std::printf("  %12s", target.title);
    }
    std::printf("\n%-24s", "angiopose");
    for (const BenchmarkTarget& target : targets) {
        std::printf("  %12.2f", reporter.medianMs(nameOf(target, "angiopose")));
    }
    std::printf("\nover that of                                                      aim, degraded\n");
    printRatios(reporter, refineKnown, true);
    for (const core::MethodInfo& info : core::methodInfos()) {
        if (info.id != "angiopose") {
            printRatios(reporter, std::string(info.id), false);
        }
    }
}

void printTracking(const MedianReporter& reporter)
{
    const double trackMs = reporter.medianMs("tracking/frame") - reporter.medianMs("tracking/map");
    const double theirsMs = reporter.medianMs(refineKnown);
    if (trackMs > 0.0 && theirsMs > 0.0) {
        std::printf("tracking without map %.2f ms, %s %.2f ms: %.3f of it (aim: at most %.3f)\n", trackMs,
                    refineKnown.c_str(), theirsMs, trackMs / theirsMs, trackingAim);
    }
}

}   // namespace

int main(int argc, char** argv)
{
    addAll();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    MedianReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    printTimes(reporter);
    printTracking(reporter);
    return 0;
}
