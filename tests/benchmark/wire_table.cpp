// Tests registration when only a guidewire is visible: its path, the pose of the tree, and whether the program knows
// its possible error. Thresholds come from the artificial cases; trees of patients and a different guidewire model are
// the test set.

#include "core/registration/registration.h"
#include "core/support/quantile.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/judging_cases.h"
#include "tests/benchmark/wire_cases.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>

using namespace angiopose;

namespace {

using namespace benchmarks;

const char* const usage =
    "wire_table\n"
    "  --world <name>    judging: trees of patients; made-up: what thresholds were chosen on (judging)\n"
    "  --cases <n>       of the made-up world (200)\n"
    "  --trials <n>      of the judging world, for each tree (5)\n"
    "  --others <0|1>    what was there before, too (1)\n"
    "  --dump <file>     CSV of every run\n";

constexpr double offMm = 3.0;   // maximum error of a reliable overlay, and of a true path
constexpr double besideMm = 1.5;   // maximum distance from an axis to count as on it
constexpr double sameWay = 0.8;   // minimum share of the visible course of each path that runs along the other

struct WireRun {
    double errorMm = 0.0;   ///< mean over the whole tree's overlay
    double errorOnWayMm = 0.0;   ///< of the vessels that contain the guidewire
    double expectedMm = 0.0;
    int rank = 0;   ///< rank of the first true path, from 1; 0: none of the paths
    int rankWithin = 0;   ///< rank of the first path whose pose puts the visible course within 3 mm
    double probability = 0.0;   ///< stated for the first path
    bool isTrusted = false;
    double timeMs = 0.0;
};

double shiftMm(const WireCase& made, const Eigen::Vector3d& point, const core::RigidTransform& pose)
{
    const Eigen::Vector3d truth = made.cameraFromPatient * point;
    const auto a = core::project(made.input.camera, truth);
    const auto b = core::project(made.input.camera, pose * point);
    return a && b ? (*a - *b).norm() * core::millimetersPerPixel(made.input.camera, truth.z()) : 100.0;
}

/// Share of a course that runs along the other, measured by its true projection: parts along the ray are not visible.
double shareBeside(const WireCase& made, const std::vector<Eigen::Vector3d>& course,
                   const std::vector<Eigen::Vector3d>& other)
{
    double visiblePx = 0.0;
    double besidePx = 0.0;
    for (std::size_t i = 1; i < course.size(); ++i) {
        const auto from = core::project(made.input.camera, made.cameraFromPatient * course[i - 1]);
        const auto to = core::project(made.input.camera, made.cameraFromPatient * course[i]);
        const double lengthPx = from && to ? (*to - *from).norm() : 0.0;
        visiblePx += lengthPx;
        besidePx += std::ranges::any_of(
                        other, [&](const Eigen::Vector3d& point) { return (point - course[i]).norm() < besideMm; })
                        ? lengthPx
                        : 0.0;
    }
    return visiblePx > 0.0 ? besidePx / visiblePx : 0.0;
}

/// True if the visible courses agree: most of each runs along the other.
bool isTrueWay(const WireCase& made, const core::WirePath& path)
{
    return shareBeside(made, made.axisInPatient, path.courseInPatient) >= sameWay &&
           shareBeside(made, path.courseInPatient, made.axisInPatient) >= sameWay;
}

double errorOnWayMm(const WireCase& made, const core::RigidTransform& pose)
{
    double sum = 0.0;
    for (const Eigen::Vector3d& point : made.axisInPatient) {
        sum += shiftMm(made, point, pose);
    }
    return sum / static_cast<double>(made.axisInPatient.size());
}

/// Rank of the first path for which the predicate holds, from 1; 0 if there is none.
template <class Holds>
int placeOf(const std::vector<core::WirePath>& paths, const Holds& holds)
{
    const auto found = std::ranges::find_if(paths, holds);
    return found == paths.end() ? 0 : static_cast<int>(found - paths.begin()) + 1;
}

WireRun runOf(const WireCase& made, const core::RegistrationInput& input, const std::string& method)
{
    core::RegistrationOptions options;
    options.method = method;
    const auto start = std::chrono::steady_clock::now();
    const auto result = core::registerVessels(input, options);
    WireRun run;
    run.timeMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (!result) {
        std::fprintf(stderr, "%s\n", result.error().message.text().c_str());
        return run;
    }
    const core::RigidTransform& pose = result.value().cameraFromPatient;
    double count = 0.0;
    for (const core::VesselBranch& branch : made.input.tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            run.errorMm += shiftMm(made, point, pose);
            count += 1.0;
        }
    }
    run.errorMm /= count;
    run.errorOnWayMm = errorOnWayMm(made, pose);
    run.expectedMm = result.value().indicators.expectedErrorMm;
    run.isTrusted = result.value().trustworthy;
    const auto& paths = result.value().wirePaths;
    run.probability = paths.empty() ? 0.0 : paths.front().probability;
    run.rank = placeOf(paths, [&](const core::WirePath& path) { return isTrueWay(made, path); });
    run.rankWithin = placeOf(paths, [&](const core::WirePath& path) {
        return isTrueWay(made, path) && errorOnWayMm(made, path.cameraFromPatient) <= offMm;
    });
    return run;
}

/// The method available before: excludes every branch that does not contain the guidewire.
core::RegistrationInput withoutOthers(const WireCase& made)
{
    core::RegistrationInput input = made.input;
    for (const core::VesselBranch& branch : input.tree.branches) {
        if (std::ranges::count(made.branchIds, branch.id) == 0) {
            input.excludedBranchIds.push_back(branch.id);
        }
    }
    return input;
}

std::size_t countIf(const std::vector<WireRun>& runs, bool (*holds)(const WireRun&))
{
    return static_cast<std::size_t>(std::ranges::count_if(runs, holds));
}

double medianOf(const std::vector<WireRun>& runs, double WireRun::*value)
{
    std::vector<double> values;
    for (const WireRun& run : runs) {
        values.push_back(run.*value);
    }
    return core::quantile(values, 0.5);
}

void print(const std::string& name, const std::vector<WireRun>& runs)
{
    const std::size_t trusted = countIf(runs, [](const WireRun& run) { return run.isTrusted; });
    const std::size_t trustedOff =
        countIf(runs, [](const WireRun& run) { return run.isTrusted && run.errorMm > offMm; });
    std::printf("%-30s %5zu %6zu %8zu %7zu %7.2f %8.2f %8zu %12zu %6zu %6.0f\n", name.c_str(), runs.size(),
                countIf(runs, [](const WireRun& run) { return run.rank == 1; }),
                countIf(runs, [](const WireRun& run) { return run.rank >= 1 && run.rank <= 3; }),
                countIf(runs, [](const WireRun& run) { return run.rankWithin >= 1 && run.rankWithin <= 3; }),
                medianOf(runs, &WireRun::errorOnWayMm), medianOf(runs, &WireRun::errorMm), trusted, trustedOff,
                countIf(runs, [](const WireRun& run) { return run.errorMm > offMm; }),
                medianOf(runs, &WireRun::timeMs));
}

void printReliability(const std::vector<WireRun>& runs)
{
    std::printf("\n%-14s %5s %6s\n", "probability", "runs", "right");
    double from = 0.0;
    for (const double to : {0.3, 0.5, 0.7, 0.9, 0.97, 1.01}) {
        std::size_t count = 0;
        std::size_t right = 0;
        for (const WireRun& run : runs) {
            const bool isIn = run.probability >= from && run.probability < to;
            count += isIn ? 1 : 0;
            right += isIn && run.rank == 1 ? 1 : 0;
        }
        std::printf("%.2f – %.2f    %5zu %6zu\n", from, std::min(to, 1.0), count, right);
        from = to;
    }
}

std::vector<WireCase> casesOf(const Arguments& arguments)
{
    std::vector<WireCase> cases;
    if (arguments.text("world", "judging") == "made-up") {
        const auto count = static_cast<std::uint64_t>(arguments.number("cases", 200));
        for (std::uint64_t number = 0; number < count; ++number) {
            cases.push_back(madeUpWireCase(number));
        }
    } else {
        std::uint64_t number = 0;
        for (const RootedTree& tree : judgingTrees(TEST_DATA_DIR)) {
            for (int trial = 0; trial < static_cast<int>(arguments.number("trials", 5)); ++trial) {
                cases.push_back(judgingWireCase(tree, number++));
            }
        }
    }
    std::erase_if(cases, [](const WireCase& made) { return made.axisInPatient.size() < 30; });
    return cases;
}

}   // namespace

int main(int argc, char** argv)
{
    const Arguments arguments(argc, argv, usage);
    const std::vector<WireCase> cases = casesOf(arguments);
    if (cases.empty()) {
        std::fprintf(stderr, "The trees of patients are not there.\n");
        return 1;
    }
    std::vector<WireRun> wire;
    std::vector<WireRun> whole;
    std::vector<WireRun> alone;
    std::vector<double> offAxis;
    for (const WireCase& made : cases) {
        wire.push_back(runOf(made, made.input, "wire"));
        if (arguments.number("others", 1) > 0) {
            whole.push_back(runOf(made, made.input, "angiopose"));
            alone.push_back(runOf(made, withoutOthers(made), "angiopose"));
        }
        offAxis.push_back(made.offAxisMm);
    }
    if (const std::string path = arguments.text("dump", ""); !path.empty()) {
        std::ofstream file(path);
        file << "tree,rank,rankWithin,probability,trusted,errorMm,errorOnWayMm,expectedMm,offAxisMm\n";
        for (std::size_t i = 0; i < wire.size(); ++i) {
            file << cases[i].tree << ',' << wire[i].rank << ',' << wire[i].rankWithin << ',' << wire[i].probability
                 << ',' << wire[i].isTrusted << ',' << wire[i].errorMm << ',' << wire[i].errorOnWayMm << ','
                 << wire[i].expectedMm << ',' << offAxis[i] << '\n';
        }
    }
    std::printf("%zu wires, median %.2f mm off the axis\n\n", cases.size(), core::quantile(offAxis, 0.5));
    std::printf(
        "True way: %.0f %% of the visible course lies within %.1f mm of the way's, and the same of the way's.\n"
        "Pose: it is one of them, and its pose puts the visible course within %.0f mm.\n\n",
        100.0 * sameWay, besideMm, offMm);
    std::printf("%-30s %5s %6s %8s %7s %7s %8s %8s %12s %6s %6s\n", "", "runs", "first", "first 3", "+pose", "way mm",
                "tree mm", "trusted", "of them>3mm", ">3mm", "ms");
    print("wire", wire);
    if (!whole.empty()) {
        print("angiopose, whole tree", whole);
        print("angiopose, other branches out", alone);
    }
    const std::size_t trusted = countIf(wire, [](const WireRun& run) { return run.isTrusted; });
    std::printf("\ntrusted while more than %.0f mm off: %zu of %zu\n", offMm,
                countIf(wire, [](const WireRun& run) { return run.isTrusted && run.errorMm > offMm; }), trusted);
    printReliability(wire);
    return 0;
}
