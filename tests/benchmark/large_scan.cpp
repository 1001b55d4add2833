#include "tests/benchmark/large_scan.h"

#include "core/simulation/simulate_cta.h"
#include "core/tracing/volume/trace_vessels.h"
#include "tests/benchmark/timing.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace angiopose::benchmarks {
namespace {

/// Peak memory of the program since `forgetPeak`, MB.
double peakMb()
{
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word == "VmHWM:") {
            double kb = 0.0;
            status >> kb;
            return kb / 1024.0;
        }
    }
    return 0.0;
}

void forgetPeak()
{
    std::ofstream("/proc/self/clear_refs") << "5";
}

class StageClock {
public:
    void enter(std::string_view stage)
    {
        const auto now = std::chrono::steady_clock::now();
        if (!stages_.empty() && stages_.back().first == stage) {
            return;
        }
        if (!stages_.empty()) {
            stages_.back().second = std::chrono::duration<double>(now - entered_).count();
        }
        stages_.emplace_back(stage, 0.0);
        entered_ = now;
    }

    void print() const
    {
        for (const auto& [stage, seconds] : stages_) {
            if (!stage.empty()) {
                std::printf("  %-12s %5.2f s\n", stage.c_str(), seconds);
            }
        }
    }

private:
    std::vector<std::pair<std::string, double>> stages_;
    std::chrono::steady_clock::time_point entered_;
};

core::SimulatedCta largeScan()
{
    core::CtaOptions large;
    large.size = {512, 512, 300};
    large.spacingMm = {0.7, 0.7, 1.0};
    core::TreeOptions tree;
    tree.branchCount = 40;
    tree.rootRadiusMm = 9.0;
    tree.extentMm = 260.0;
    return core::simulateCta(1, tree, large);
}

void printLarge(const core::Volume& scan)
{
    const double volumeMb = static_cast<double>(scan.voxels.size()) * 2.0 / (1024.0 * 1024.0);
    forgetPeak();
    const double before = peakMb();
    std::size_t branches = 0;
    StageClock stages;
    const Timing time = timed([&] {
        const auto traced = core::traceVessels(scan, {}, [&](const core::TracingReport& report) {
            stages.enter(report.stage);
            return core::ObserverDecision::Continue;
        });
        branches = traced ? traced.value().tree.branches.size() : 0;
        stages.enter("");
    });
    std::printf(
        "512 x 512 x 300 (%.0f MB): %zu branches, wall %.1f s, processor %.1f s, peak memory %.2f x the volume "
        "(volume included)\n",
        volumeMb, branches, time.wall, time.processor, (peakMb() - before + volumeMb) / volumeMb);
    stages.print();
}

/// Requests a stop at ten times during tracing and prints how long the tracer takes to return.
void printStops(const core::Volume& scan, const core::VesselTracingOptions& options, const char* name)
{
    constexpr int stops = 10;
    const double whole = timed([&] { (void)core::traceVessels(scan, options); }).wall;
    double worst = 0.0;
    double sum = 0.0;
    std::string_view worstStage;
    for (int n = 0; n < stops; ++n) {
        const double pressed = whole * (n + 0.5) / stops;
        const auto start = std::chrono::steady_clock::now();
        const auto passed = [&] {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        };
        std::string_view stage;
        (void)core::traceVessels(scan, options, [&](const core::TracingReport& report) {
            stage = report.stage;
            return passed() >= pressed ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
        });
        const double answer = std::max(0.0, passed() - pressed);
        sum += answer;
        if (answer > worst) {
            worst = answer;
            worstStage = stage;
        }
    }
    std::printf("%s, stopped at %d times of %.1f s: answered after %.2f s on average, at most %.2f s (in \"%s\")\n",
                name, stops, whole, sum / stops, worst, std::string(worstStage).c_str());
}

}   // namespace

void printLargeScan()
{
    const core::SimulatedCta cta = largeScan();
    printLarge(cta.volume);
    printStops(cta.volume, {}, "no seed");
    printStops(cta.volume, {.seedsInPatient = {cta.tree.branches.front().pointsInPatient[5]}}, "one seed");
}

}   // namespace angiopose::benchmarks
