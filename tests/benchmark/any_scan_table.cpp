// Prints the result of tracing without a seed on scans of many kinds: heads by CT and MR, rotational angiography, MR
// angiography with coil sensitivity falloff, thick slices, crops. Right: the tree begins in a great artery and contains
// little else. Asked: nothing was traced, and the user is asked to place a seed. Wrong: everything else.

#include "core/evaluation/report/result_table.h"
#include "core/support/format_number.h"
#include "core/support/quantile.h"
#include "core/tracing/volume/trace_vessels.h"
#include "io/evaluation/table_text.h"
#include "io/volume_file.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/timing.h"
#include "tests/support/bodies/simulate_any_scan.h"
#include "tests/support/tree_agreement.h"

#include <algorithm>
#include <cstdio>
#include <optional>

using namespace angiopose;

namespace {

using core::fixedText;

const char* const usage =
    "any_scan_table [--seeds <n>] [--first <seed>] [--judge ] [--kinds <list>] [--words ] [--clicks ] [--save "
    "<folder>]\n"
    "  --seeds <n>      scans of each kind (2), from --first on (1)\n"
    "  --judge          from the ranges that judge, instead of those for choosing constants\n"
    "  --kinds <list>   as the table names them (all)\n"
    "  --words          what was said of each\n"
    "  --clicks         with a seed in a great artery, as a user answers the question\n"
    "  --save <folder>  writes the scans there, to be looked at\n";

constexpr double maxFalse = 0.10;   // share of the traced length
constexpr double besideMm = 1.5;   // distance of the root outside the artery

enum class ObserverDecision { Right, Asked, Wrong };

struct Outcome {
    ObserverDecision verdict = ObserverDecision::Wrong;
    double falseShare = 0.0;
    double found = 0.0;
    double falseMm = 0.0;
    int stubs = 0;   ///< branches shorter than 15 mm that are mostly false
    std::string words;
    std::string places;   ///< locations of the false parts
};

std::string placeText(const Eigen::Vector3d& place)
{
    return fixedText(place.x(), 0) + " " + fixedText(place.y(), 0) + " " + fixedText(place.z(), 0);
}

bool asksForSeed(const core::Message& message)
{
    return message.text().find("seed") != std::string::npos;
}

bool holds(const core::VesselBranch& branch, const Eigen::Vector3d& place)
{
    for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
        if ((branch.pointsInPatient[n] - place).norm() <= branch.radiusMm[n] + besideMm) {
            return true;
        }
    }
    return false;
}

bool beginsInGreatArtery(const core::VesselTree& tree, const core::AnyScan& scan)
{
    const Eigen::Vector3d root = tree.branches.front().pointsInPatient.front();
    const auto isGreat = [&](const core::VesselBranch& branch) {
        return std::ranges::find(scan.great, branch.id) != scan.great.end();
    };
    return std::ranges::any_of(
               scan.arteries.branches,
               [&](const core::VesselBranch& branch) { return isGreat(branch) && holds(branch, root); }) ||
           std::ranges::any_of(scan.upstream.branches,
                               [&](const core::VesselBranch& branch) { return holds(branch, root); });
}

Outcome outcomeOf(const core::AnyScan& scan, const core::Result<core::TracedVessels>& traced)
{
    Outcome outcome;
    if (!traced) {
        outcome.verdict = asksForSeed(traced.error().message) ? ObserverDecision::Asked : ObserverDecision::Wrong;
        outcome.words = traced.error().message.text();
        return outcome;
    }
    const core::VesselTree& tree = traced.value().tree;
    const double voxelMm = scan.volume.geometry.spacingMm.maxCoeff();
    core::VesselTree truth = scan.arteries;
    truth.branches.insert(truth.branches.end(), scan.upstream.branches.begin(), scan.upstream.branches.end());
    const auto agreement = test::agreementOf(tree, truth, voxelMm);
    outcome.falseShare = 1.0 - agreement.right;
    outcome.found = test::agreementOf(tree, scan.seen, voxelMm).found;
    for (const core::VesselBranch& branch : tree.branches) {
        core::VesselTree alone;
        alone.branches = {branch};
        const double falseShare = 1.0 - test::agreementOf(alone, truth, voxelMm).right;
        outcome.falseMm += falseShare * branch.lengthMm();
        if (const double mm = falseShare * branch.lengthMm(); mm > 5.0) {
            outcome.places += placeText(branch.pointsInPatient[branch.pointsInPatient.size() / 2]) + " r " +
                              fixedText(core::medianOf(branch.radiusMm), 1) + ": " + fixedText(mm, 0) + " mm; ";
        }
        outcome.stubs += falseShare > 0.5 && branch.lengthMm() < 15.0 ? 1 : 0;
    }
    const bool isRight = beginsInGreatArtery(tree, scan) && outcome.falseShare <= maxFalse;
    outcome.verdict = isRight ? ObserverDecision::Right : ObserverDecision::Wrong;
    const core::VesselBranch& first = tree.branches.front();
    outcome.words = "from " + fixedText(traced.value().threshold, 0) + ", root of " +
                    fixedText(core::medianOf(first.radiusMm), 1) + " mm, " + std::to_string(tree.branches.size()) +
                    " branches, root at " + placeText(first.pointsInPatient.front()) + ". False: " + outcome.places;
    for (const core::Message& warning : traced.value().warnings) {
        outcome.words += warning.text() + " ";
    }
    return outcome;
}

const char* nameOf(ObserverDecision verdict)
{
    return verdict == ObserverDecision::Right ? "right" : verdict == ObserverDecision::Asked ? "asked" : "WRONG";
}

core::VesselTracingOptions optionsFor(const core::AnyScan& scan, bool hasClick)
{
    core::VesselTracingOptions options;
    if (hasClick) {
        for (const core::VesselBranch& branch : scan.seen.branches) {
            if (branch.generation == 0 && options.seedsInPatient.empty()) {
                options.seedsInPatient = {branch.pointsInPatient[branch.pointsInPatient.size() / 2]};
            }
        }
    }
    return options;
}

}   // namespace

int main(int count, char** values)
{
    const benchmarks::Arguments arguments(count, values, usage);
    const int first = static_cast<int>(arguments.number("first", 1));
    const int seeds = static_cast<int>(arguments.number("seeds", 2));
    const auto ranges = arguments.isSet("judge") ? core::ScanRanges::Judging : core::ScanRanges::Choosing;
    const std::string folder = arguments.text("save", "");
    const std::vector<std::string> asked = arguments.list("kinds", "all");
    core::ResultTable table;
    table.title = ranges == core::ScanRanges::Judging ? "Any scan, judging ranges" : "Any scan, choosing ranges";
    table.columns = {"scan", "seed", "verdict", "false length", "false [mm]", "found", "false stubs", "wall [s]"};
    std::array<int, 3> verdicts{};
    for (const core::NamedScanKind& kind : core::allScanKinds()) {
        if (asked.front() != "all" && std::ranges::find(asked, kind.name) == asked.end()) {
            continue;
        }
        for (int seed = first; seed < first + seeds; ++seed) {
            const core::AnyScan scan = core::simulateAnyScan(kind.kind, static_cast<std::uint64_t>(seed), ranges);
            if (!folder.empty()) {
                const auto written =
                    io::writeVolume(scan.volume, folder + "/" + kind.name + std::to_string(seed) + ".nii.gz");
                std::printf("%s", written ? "" : (written.error().message.text() + "\n").c_str());
            }
            const core::VesselTracingOptions options = optionsFor(scan, arguments.isSet("clicks"));
            std::optional<core::Result<core::TracedVessels>> traced;
            const double wall = benchmarks::timed([&] { traced = core::traceVessels(scan.volume, options); }).wall;
            const Outcome outcome = outcomeOf(scan, *traced);
            ++verdicts[static_cast<std::size_t>(outcome.verdict)];
            table.rows.push_back({{kind.name, std::to_string(seed), nameOf(outcome.verdict),
                                   fixedText(outcome.falseShare, 3), fixedText(outcome.falseMm, 0),
                                   fixedText(outcome.found, 3), std::to_string(outcome.stubs), fixedText(wall, 1)},
                                  false});
            if (arguments.isSet("words")) {
                std::printf("%s %d: %s: %s\n", kind.name, seed, nameOf(outcome.verdict), outcome.words.c_str());
                std::fflush(stdout);
            }
        }
    }
    std::printf("%s\nright %d, asked %d, wrong %d\n", io::toPlainText(table).c_str(), verdicts[0], verdicts[1],
                verdicts[2]);
    return 0;
}
