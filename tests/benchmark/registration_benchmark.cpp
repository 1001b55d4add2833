// Time of one registration on one core, 2000 points, 512 × 512, with target map, search and judging, against OpenCV's
// solvers that are told the correspondences and against the other methods; and time of one frame when tracking, the new
// target map excluded. Medians and their ratios from one run.

#include "core/evaluation/protocols/protocol.h"
#include "core/evaluation/trial/contestant.h"
#include "core/registration/methods/method_info.h"
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

constexpr std::size_t trialCount = 20;   ///< start poses, taken in turn
constexpr int repetitions = 5;
constexpr std::array targets{"obj-2-5", "degraded-obj-2-5"};

/// Made once for each condition; every method sees the same.
const std::vector<core::Trial>& trialsOf(const std::string& condition)
{
    static std::map<std::string, std::vector<core::Trial>> made;
    std::vector<core::Trial>& trials = made[condition];
    if (trials.empty()) {
        const core::Protocol& simulation = *core::findProtocol("simulation");
        const auto maker = simulation.prepare(core::conditionsFrom(simulation, condition).value().front(), 1);
        for (std::uint64_t number = 0; number < trialCount; ++number) {
            trials.push_back(maker(number));
        }
    }
    return trials;
}

void registerOnce(benchmark::State& state, const std::string& method, const std::string& condition)
{
    const std::vector<core::Trial>& trials = trialsOf(condition);
    const core::Contestant contestant = core::contestantFrom(method).value();
    const core::RegistrationOptions options = core::optionsFor(contestant, trials.front().targetIsExact);
    StageSum stages;
    std::size_t next = 0;
    while (state.KeepRunning()) {
        const auto result = core::registerVessels(trials[next++ % trialCount].input, options);
        if (!result) {
            state.SkipWithError(result.error().message.text().c_str());
            return;
        }
        stages.add(result.value().time);
    }
    stages.report(state);
}

void solveKnown(benchmark::State& state, FoundPose (*solve)(const KnownPartners&))
{
    std::vector<KnownPartners> all;
    for (const core::Trial& trial : trialsOf(targets.front())) {
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

/// Frame by frame through a run, map and all.
void trackFrames(benchmark::State& state)
{
    const BreathingRun run = breathingRun(trialsOf(targets.front()).front(), trialCount);
    core::FrameTracker tracker(run.first, {});
    std::vector<core::RigidTransform> found;
    int searches = 0;
    while (state.KeepRunning()) {
        const core::TrackedFrame frame = tracker.next(run.targets[found.size()]).value();
        found.push_back(frame.cameraFromPatient);
        searches += frame.searched ? 1 : 0;
    }
    double worstPx = 0.0;
    for (std::size_t frame = 0; frame < found.size(); ++frame) {
        worstPx = std::max(worstPx, run.errorPx(found[frame], frame));
    }
    state.counters["worst_px"] = worstPx;
    state.counters["searches"] = searches;
}

/// The same frames' maps alone.
void mapFrames(benchmark::State& state)
{
    const BreathingRun run = breathingRun(trialsOf(targets.front()).front(), trialCount);
    std::size_t next = 0;
    while (state.KeepRunning()) {
        const core::TargetSamples target = core::sampledTarget(run.targets[next++ % trialCount], {});
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

void addAll()
{
    add("known/solvePnPRefineLM", [](benchmark::State& state) { solveKnown(state, refineLm); });
    add("known/SQPNP", [](benchmark::State& state) { solveKnown(state, sqpnp); });
    add("tracking/frame", trackFrames);
    add("tracking/map", mapFrames);
    for (const std::string condition : targets) {
        for (const core::MethodInfo& info : core::methodInfos()) {
            add(condition + "/" + std::string(info.id),
                [method = std::string(info.id), condition](benchmark::State& state) {
                    registerOnce(state, method, condition);
                });
        }
    }
}

void printRatio(const MedianReporter& reporter, const std::string& other, double aim)
{
    const double oursMs = reporter.medianMs(std::string(targets.front()) + "/angiopose");
    const double theirsMs = reporter.medianMs(other);
    if (oursMs > 0.0 && theirsMs > 0.0) {
        std::printf("angiopose %.2f ms, %s %.2f ms: %.2f of it (aim: at most %.2f)\n", oursMs, other.c_str(), theirsMs,
                    oursMs / theirsMs, aim);
    }
}

void printTracking(const MedianReporter& reporter)
{
    const double trackMs = reporter.medianMs("tracking/frame") - reporter.medianMs("tracking/map");
    const double theirsMs = reporter.medianMs("known/solvePnPRefineLM");
    if (trackMs > 0.0 && theirsMs > 0.0) {
        std::printf("tracking without map %.2f ms, known/solvePnPRefineLM %.2f ms: %.3f of it (aim: at most %.3f)\n",
                    trackMs, theirsMs, trackMs / theirsMs, 1.0 / 6.0);
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
    std::printf("\nMedian processor time of one registration\n");
    printRatio(reporter, "known/solvePnPRefineLM", 1.0);
    printRatio(reporter, std::string(targets.front()) + "/assembled-icp", 1.0 / 3.0);
    printRatio(reporter, std::string(targets.front()) + "/iterative-pnp", 0.2);
    printTracking(reporter);
    return 0;
}
