// Measures the diameters that the project's tracing finds for simulated vessels, and whether diameters help to find one
// wide vessel among thin ones. Trees grown step by step serve to choose constants; cerebral arteries of patients are
// the test set.

#include "core/registration/matching/target_lines.h"
#include "core/simulation/form_dsa_frames.h"
#include "core/support/format_number.h"
#include "core/support/quantile.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/foreign/answer.h"
#include "tests/benchmark/grown_trees.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace angiopose;

namespace {

using namespace benchmarks;

constexpr double goodMm = 2.0;
constexpr double onVesselPx = 4.0;
constexpr double opacityOfVessels = 0.8;

const char* const usage =
    "diameter_table\n"
    "  --family <name>   development: trees grown step by step; real: cerebral arteries of patients (development)\n"
    "  --scene <name>    wide: one wide vessel beside fine ones; whole: the whole tree (wide)\n"
    "  --trees <n>       of the development family (10)\n"
    "  --first <n>       number of its first tree (0)\n"
    "  --trials <n>      for each tree (2)\n"
    "  --each            one line for each registration, too\n";

struct TracedCase {
    ForeignCase asked;
    bool isTraced = false;
};

/// Every branch that the image shows, as a path of contrast agent from its origin.
std::vector<core::ContrastPath> pathsOf(const ForeignCase& asked)
{
    std::vector<core::ContrastPath> paths;
    for (const std::size_t number : asked.filled) {
        const core::VesselBranch& branch = asked.input.tree.branches[number];
        core::ContrastPath path;
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            path.push_back({branch.pointsInPatient[i], branch.radiusMm[i], opacityOfVessels, 0.0});
        }
        paths.push_back(std::move(path));
    }
    return paths;
}

/// Adds curves that belong to no branch of the tree, at the depth of the tree.
void addForeignPaths(const ForeignCase& asked, ForeignRandom random, std::vector<core::ContrastPath>& paths)
{
    const core::ProjectionCamera& camera = asked.input.camera;
    const double depthMm = (asked.truth * core::centroidInPatient(asked.input.tree)).z();
    const core::RigidTransform patientFromCamera = asked.truth.inverse();
    const std::size_t curves = asked.input.target.curves.size();
    for (std::size_t c = curves - asked.foreignCurves; c < curves; ++c) {
        const double radiusMm = random.uniform(0.4, 0.8);
        core::ContrastPath path;
        for (const Eigen::Vector2d& pixel : asked.input.target.curves[c].pointsPx) {
            const Eigen::Vector3d ray = core::rayThroughPixel(camera, pixel);
            path.push_back({patientFromCamera * (ray * (depthMm / ray.z())), radiusMm, opacityOfVessels, 0.0});
        }
        paths.push_back(std::move(path));
    }
}

/// Renders the case as a frame with the simulator and traces it with the project's tracing.
TracedCase tracedCase(ForeignCase asked, std::uint64_t seed)
{
    std::vector<core::ContrastPath> paths = pathsOf(asked);
    addForeignPaths(asked, ForeignRandom(seed), paths);
    core::DsaOptions options;
    options.width = asked.input.camera.width;
    options.height = asked.input.camera.height;
    options.frameCount = 1;
    options.shutterProbability = 0.0;
    const core::DsaScene scene{std::move(paths), 200.0, asked.input.camera, asked.truth};
    const core::DsaRun run = core::formDsaFrames(scene, options, core::CounterRandom(seed));
    const auto traced = core::traceAngiogram(run.frames.front(), core::Polarity::VesselsDark);
    TracedCase result{std::move(asked), bool(traced)};
    if (traced) {
        result.asked.input.target = traced.value().centerline;
    }
    return result;
}

struct WidthsAtTruth {
    double scale = 0.0;   ///< median of the log of traced over expected diameter
    std::vector<double> off;   ///< deviation of each point from `scale`
};

WidthsAtTruth widthsAtTruth(const ForeignCase& asked)
{
    const core::RegistrationProblem problem = core::makeProblem(asked.input, {}).value();
    const core::TargetLines lines(problem.target, problem.camera);
    WidthsAtTruth widths;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < problem.tree.size(); ++i) {
        const Eigen::Vector3d inCamera = asked.truth * problem.tree.points[i];
        const auto pixel = core::project(problem.camera, inCamera);
        if (!pixel || !(problem.tree.radiusMm[i] > 0.0)) {
            continue;
        }
        const core::TargetLines::Line& line = lines.nearest(pixel->x(), pixel->y());
        const double seenPx = problem.target.radiusPx[static_cast<std::size_t>(&line - lines.lines().data())];
        if (core::TargetLines::squaredDistance(line, pixel->x(), pixel->y()) < onVesselPx * onVesselPx &&
            seenPx > 0.0) {
            ratios.push_back(
                std::log(seenPx * core::millimetersPerPixel(problem.camera, inCamera.z()) / problem.tree.radiusMm[i]));
        }
    }
    if (!ratios.empty()) {
        widths.scale = core::medianOf(ratios);
        std::ranges::transform(ratios, std::back_inserter(widths.off), [&](double r) { return r - widths.scale; });
    }
    return widths;
}

std::vector<RootedTree> treesAsked(const Arguments& arguments)
{
    if (arguments.text("family", "development") == "real") {
        return treesOfFamily("real");
    }
    std::vector<RootedTree> trees;
    const auto first = static_cast<std::uint64_t>(arguments.number("first", 0));
    const auto count = static_cast<std::uint64_t>(arguments.number("trees", 10));
    for (std::uint64_t number = first; number < first + count; ++number) {
        trees.push_back(grownTree(number));
    }
    return trees;
}

void printWidths(const std::vector<WidthsAtTruth>& all)
{
    std::vector<double> scales, offs;
    for (const WidthsAtTruth& one : all) {
        scales.push_back(one.scale);
        std::ranges::transform(one.off, std::back_inserter(offs), [](double off) { return std::abs(off); });
    }
    const auto five = [](const std::vector<double>& values) {
        std::string text;
        for (const double fraction : {0.05, 0.25, 0.5, 0.75, 0.95}) {
            text += "  " + core::fixedText(core::quantile(values, fraction), 3);
        }
        return text;
    };
    std::printf(
        "log(seen/expected) at the true pose, 5, 25, 50, 75, 95 %%\n  common to an image %s\n"
        "  off that, absolute %s\n",
        five(scales).c_str(), five(offs).c_str());
}

}   // namespace

int main(int argc, char** argv)
{
    const Arguments arguments(argc, argv, usage);
    const std::vector<RootedTree> trees = treesAsked(arguments);
    const auto trials = static_cast<std::uint64_t>(arguments.number("trials", 2));
    const ForeignScene scene =
        arguments.text("scene", "wide") == "whole" ? ForeignScene::WholeTree : ForeignScene::WideVessel;
    std::vector<WidthsAtTruth> widths;
    int good = 0, trusted = 0, trustedWrong = 0, count = 0;
    std::vector<double> errors, times;
    for (std::size_t tree = 0; tree < trees.size(); ++tree) {
        for (std::uint64_t trial = 0; trial < trials; ++trial) {
            const TracedCase made = tracedCase(makeForeignCase(trees, tree, scene, trial), 1000 * tree + trial);
            if (!made.isTraced) {
                continue;
            }
            widths.push_back(widthsAtTruth(made.asked));
            const ForeignAnswer answer = ask(made.asked);
            const bool isGood = answer.error.inPlaneMm < goodMm;
            good += isGood ? 1 : 0;
            trusted += isGood && answer.isTrusted ? 1 : 0;
            trustedWrong += !isGood && answer.isTrusted ? 1 : 0;
            errors.push_back(answer.error.inPlaneMm);
            times.push_back(answer.timeMs);
            ++count;
            if (arguments.isSet("each")) {
                std::printf("%-12s %2d  %8.3f mm  %6.2f°  %s  %6.0f ms\n", trees[tree].name.c_str(),
                            static_cast<int>(trial), answer.error.inPlaneMm, answer.error.turnDeg,
                            answer.isTrusted ? "trusted" : "flagged", answer.timeMs);
                std::fflush(stdout);
            }
        }
    }
    if (count == 0) {
        return 1;
    }
    std::printf("%d frames of %zu trees through the tracing\n", count, trees.size());
    printWidths(widths);
    std::printf(
        "below 2 mm %d of %d, of them trusted %d; others trusted %d; median %.2f mm, median %.0f ms, longest %.0f\n",
        good, count, trusted, trustedWrong, core::quantile(errors, 0.5), core::quantile(times, 0.5),
        core::quantile(times, 1.0));
    return 0;
}
