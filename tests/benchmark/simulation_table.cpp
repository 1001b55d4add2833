// Registers generated trees from random start poses and prints how far off each method ends (ALGORITHMS §4.2).

#include "core/support/quantile.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/parallel_for.h"
#include "tests/benchmark/simulation_trial.h"
#include "tests/benchmark/text_table.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <thread>

namespace {

using namespace benchmarks;

constexpr double grossFailurePx = 5.0;
constexpr double exactPx = 1e-6;

const char* const usage =
    "simulation_table: known-correspondence errors on simulated input\n"
    "  --runs <n>        registrations per method and table (1000)\n"
    "  --trees <n>       anatomies they are spread over (10)\n"
    "  --points <n>      points per tree (2000)\n"
    "  --seed <n>        another seed, other trees and start poses (1)\n"
    "  --threads <n>     changes the time only, never the numbers (all cores)\n"
    "  --methods <list>  method or method:preset, comma-separated (angiopose,dynaweight:seed_noprior,\n"
    "                    dynaweight:seed_mean,iterative-pnp:seed_noprior)\n"
    "  --set <list>      options by their key in files, comma-separated (searchRadiusMm=100)\n"
    "  --rotation <deg>  standard deviation per axis of the start pose's rotation (2)\n"
    "  --shift <mm>      standard deviation per axis of its translation (5)\n"
    "  --worst <n>       also list the worst runs of each method (0)\n"
    "  --degrade         jittered, rasterised targets with missing branches and clutter instead of exact ones\n";

/// Trees and outcomes of one table; outcomes are stored by contestant, then by run.
struct Experiment {
    TrialPlan plan;
    std::vector<Phantom> phantoms;
    std::vector<Contestant> contestants;
    std::vector<std::vector<TrialOutcome>> outcomes;
    std::size_t runs = 0;

    const Phantom& phantomOf(std::size_t run) const { return phantoms[run % phantoms.size()]; }
};

void run(Experiment& experiment, int threads)
{
    experiment.outcomes.assign(experiment.contestants.size(), std::vector<TrialOutcome>(experiment.runs));
    parallelFor(experiment.runs, threads, [&experiment](std::size_t run) {
        const Phantom& phantom = experiment.phantomOf(run);
        const core::RegistrationInput input = makeTrialInput(phantom, experiment.plan, run);
        for (std::size_t c = 0; c < experiment.contestants.size(); ++c) {
            experiment.outcomes[c][run] = runTrial(phantom, input, experiment.contestants[c]);
        }
    });
}

template <class Read>
std::vector<double> collect(const std::vector<TrialOutcome>& outcomes, Read read)
{
    std::vector<double> values;
    std::transform(outcomes.begin(), outcomes.end(), std::back_inserter(values), read);
    return values;
}

double share(const std::vector<double>& values, double limit)
{
    const auto above = std::count_if(values.begin(), values.end(), [limit](double v) { return !(v <= limit); });
    return static_cast<double>(above) / static_cast<double>(values.size());
}

std::vector<std::string> rowOf(const Contestant& contestant, const std::vector<TrialOutcome>& outcomes)
{
    const std::vector<double> px = collect(outcomes, [](const TrialOutcome& o) { return o.projection.meanPx; });
    const std::vector<double> mm = collect(outcomes, [](const TrialOutcome& o) { return o.projection.meanMm; });
    const auto median = [&](auto read) { return core::quantile(collect(outcomes, read), 0.5); };
    const double gross = share(px, grossFailurePx);
    const double exact = 1.0 - share(px, exactPx);
    const double mean = std::accumulate(px.begin(), px.end(), 0.0) / static_cast<double>(px.size());
    const double flagged = static_cast<double>(std::count_if(outcomes.begin(), outcomes.end(), [](const auto& o) {
        return !o.trustworthy && !(o.projection.meanPx <= grossFailurePx);
    }));
    const double grossCount = gross * static_cast<double>(px.size());
    return {contestant.label,
            fixed(100.0 * gross, 1) + " %",
            grossCount > 0.5 ? fixed(100.0 * flagged / grossCount, 0) + " %" : "-",
            significant(core::quantile(px, 0.5)),
            significant(mean),
            significant(core::quantile(px, 0.95)),
            significant(core::quantile(mm, 0.5)),
            significant(core::quantile(mm, 0.95)),
            significant(median([](const TrialOutcome& o) { return o.pose.angleDeg; })),
            significant(median([](const TrialOutcome& o) { return o.pose.centroidInPlaneMm; })),
            significant(median([](const TrialOutcome& o) { return std::abs(o.pose.centroidDepthMm); })),
            fixed(100.0 * exact, 1) + " %",
            gross < 1.0 ? fixed(100.0 * exact / (1.0 - gross), 1) + " %" : "-",
            fixed(median([](const TrialOutcome& o) { return o.timeMs; }), 1)};
}

void printWorst(const Experiment& experiment, std::size_t contestant, std::size_t count)
{
    const std::vector<TrialOutcome>& outcomes = experiment.outcomes[contestant];
    std::vector<std::size_t> order(outcomes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return outcomes[a].projection.meanPx > outcomes[b].projection.meanPx;
    });
    std::printf("  worst of %s:\n", experiment.contestants[contestant].label.c_str());
    for (std::size_t i = 0; i < std::min(count, order.size()); ++i) {
        const TrialOutcome& o = outcomes[order[i]];
        std::printf("    run %4zu  tree %2zu  PR %s px  angle %s°  depth %s mm  (start: %.0f mm aside, %.1f°)%s\n",
                    order[i], order[i] % experiment.phantoms.size(), significant(o.projection.meanPx).c_str(),
                    significant(o.pose.angleDeg).c_str(), significant(o.pose.centroidDepthMm).c_str(),
                    o.start.centroidInPlaneMm, o.start.angleDeg, o.trustworthy ? "" : "  not trusted");
    }
}

void print(const Experiment& experiment, std::size_t worst)
{
    TextTable table({"method", "gross", "flagged", "PR med px", "mean", "p95", "med mm", "p95 mm", "angle °",
                     "in plane mm", "depth mm", "exact", "of basin", "time ms"});
    for (std::size_t c = 0; c < experiment.contestants.size(); ++c) {
        table.add(rowOf(experiment.contestants[c], experiment.outcomes[c]));
    }
    std::fputs(table.toText().c_str(), stdout);
    for (std::size_t c = 0; worst > 0 && c < experiment.contestants.size(); ++c) {
        printWorst(experiment, c, worst);
    }
    std::fputs("\n", stdout);
}

std::vector<Contestant> contestantsOf(const std::vector<std::string>& names, Target target)
{
    std::vector<Contestant> contestants;
    for (const std::string& name : names) {
        contestants.push_back(contestantOf(name, target));
        if (contestants.back().label.empty()) {
            std::fprintf(stderr, "no such method or preset: %s\n", name.c_str());
            std::exit(2);
        }
    }
    return contestants;
}

}   // namespace

int main(int argc, char** argv)
{
    const Arguments arguments(argc, argv, usage);
    Experiment experiment;
    experiment.runs = static_cast<std::size_t>(arguments.number("runs", 1000));
    experiment.plan.seed = static_cast<std::uint64_t>(arguments.number("seed", 1));
    experiment.plan.rotationStdDeg = arguments.number("rotation", 2.0);
    experiment.plan.translationStdMm = arguments.number("shift", 5.0);
    experiment.plan.target = arguments.isSet("degrade") ? Target::Degraded : Target::Exact;
    experiment.contestants = contestantsOf(
        arguments.list("methods", "angiopose,dynaweight:seed_noprior,dynaweight:seed_mean,iterative-pnp:seed_noprior"),
        experiment.plan.target);
    for (const std::string& assignment : arguments.list("set", "")) {
        for (Contestant& contestant : experiment.contestants) {
            if (!setOption(contestant.options, assignment)) {
                std::fprintf(stderr, "no such option: %s\n", assignment.c_str());
                return 2;
            }
        }
    }
    const int points = static_cast<int>(arguments.number("points", 2000));
    for (int tree = 0; tree < static_cast<int>(arguments.number("trees", 10)); ++tree) {
        experiment.phantoms.push_back(
            makePhantom(experiment.plan.seed * 1000 + static_cast<std::uint64_t>(tree), points));
    }
    const int threads =
        static_cast<int>(arguments.number("threads", std::max(1U, std::thread::hardware_concurrency())));

    std::printf(
        "Simulated input: %s, %d points, %zu runs over %zu trees, f = 1877 px, 512×512, depth 800 mm, seed %g\n"
        "Gross: mean distance to the true projections (PR) above 5 px; flagged: share of these not called "
        "trustworthy.\n"
        "Exact: PR below 1e-6 px, of all runs and of those that are not gross.\n\n",
        experiment.plan.target == Target::Exact ? "exact projections" : "degraded targets", points, experiment.runs,
        experiment.phantoms.size(), static_cast<double>(experiment.plan.seed));
    for (const PoseNoise noise : {PoseNoise::AboutCentroid, PoseNoise::AboutSource}) {
        experiment.plan.noise = noise;
        run(experiment, threads);
        std::printf("Start poses %g° / %g mm per axis about the %s\n", experiment.plan.rotationStdDeg,
                    experiment.plan.translationStdMm,
                    noise == PoseNoise::AboutCentroid ? "centroid (OBJ)" : "X-ray source (CAM)");
        print(experiment, static_cast<std::size_t>(arguments.number("worst", 0)));
    }
    return 0;
}
