// Prints how well single vessels are traced between two points of a scan, as by two clicks in the window: branches of
// simulated scans, a patient's coronary branches drawn next to opacified chambers, and the arteries of the thoracic
// CTA.

#include "core/evaluation/report/result_table.h"
#include "core/simulation/simulate_cta.h"
#include "core/support/format_number.h"
#include "core/support/quantile.h"
#include "core/support/random.h"
#include "core/tracing/volume/path/vessel_path.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/drawn_heart.h"
#include "tests/benchmark/thoracic_scan.h"
#include "tests/benchmark/timing.h"
#include "tests/support/tree_agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

using namespace angiopose;

namespace {

using core::fixedText;

const char* const usage =
    "path_table [--seeds <n>]\n"
    "  --seeds <n>   simulated scans (4)\n";

constexpr double wholeVessel = 0.9;   // minimum overlap
constexpr double shortestMm = 15.0;   // shorter branches need no tracing by clicks

struct PathScores {
    std::vector<double> overlaps;
    std::vector<double> distancesMm;
    std::vector<double> radiusErrors;
    std::vector<double> seconds;   ///< processor time
    int failed = 0;
};

/// A realistic click for a place, with the inaccuracy of a user.
Eigen::Vector3d clickAt(const Eigen::Vector3d& place, double voxelMm, core::CounterRandom& random)
{
    return place + 0.5 * voxelMm * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
}

void tracePath(const core::Volume& scan, const core::VesselBranch& branch, double voxelMm, core::CounterRandom& random,
               PathScores& scores)
{
    const std::size_t last = branch.pointsInPatient.size() - 1;
    const Eigen::Vector3d from = clickAt(branch.pointsInPatient[std::min<std::size_t>(2, last)], voxelMm, random);
    const Eigen::Vector3d to = clickAt(branch.pointsInPatient[last - std::min<std::size_t>(2, last)], voxelMm, random);
    std::optional<core::Result<core::VesselPath>> path;
    scores.seconds.push_back(benchmarks::timed([&] { path = core::traceVesselBetween(scan, from, to); }).processor);
    if (!*path) {
        scores.overlaps.push_back(0.0);
        ++scores.failed;
        return;
    }
    core::VesselTree traced;
    traced.branches.push_back(path->value().branch);
    core::VesselTree truth;
    truth.branches.push_back(branch);
    const test::TreeAgreement agreement = test::agreementOf(traced, truth, voxelMm);
    scores.overlaps.push_back(agreement.overlap);
    scores.distancesMm.push_back(agreement.meanDistanceMm);
    scores.radiusErrors.push_back(agreement.radiusError);
}

void addRow(core::ResultTable& table, const std::string& name, const PathScores& scores)
{
    if (scores.overlaps.empty()) {
        return;
    }
    const auto whole = std::ranges::count_if(scores.overlaps, [](double overlap) { return overlap >= wholeVessel; });
    const auto medianText = [](const std::vector<double>& values, int places) {
        return values.empty() ? std::string("-") : fixedText(core::medianOf(values), places);
    };
    table.rows.push_back(
        {{name, std::to_string(whole) + " of " + std::to_string(scores.overlaps.size()), std::to_string(scores.failed),
          medianText(scores.overlaps, 3), fixedText(std::ranges::min(scores.overlaps), 3),
          medianText(scores.distancesMm, 2), medianText(scores.radiusErrors, 3), medianText(scores.seconds, 2),
          fixedText(std::ranges::max(scores.seconds), 2)},
         false});
}

PathScores simulatedScans(int seeds)
{
    PathScores scores;
    core::CounterRandom random(11);
    for (int seed = 1; seed <= seeds; ++seed) {
        const core::SimulatedCta cta = core::simulateCta(static_cast<std::uint64_t>(seed));
        const double voxelMm = std::cbrt(cta.volume.geometry.spacingMm.prod());
        for (const core::VesselBranch& branch : cta.tree.branches) {
            if (branch.lengthMm() >= shortestMm) {
                tracePath(cta.volume, branch, voxelMm, random, scores);
            }
        }
    }
    return scores;
}

PathScores coronaries(double bloodHu)
{
    PathScores scores;
    core::CounterRandom random(13);
    for (const char* side : {"lca", "rca"}) {
        const core::VesselTree tree = benchmarks::coronaryTree(side);
        if (tree.branches.empty()) {
            continue;
        }
        const core::Volume heart = benchmarks::drawnHeart(tree, bloodHu);
        for (const core::VesselBranch& branch : tree.branches) {
            if (branch.lengthMm() >= shortestMm) {
                tracePath(heart, branch, 0.5, random, scores);
            }
        }
    }
    return scores;
}

PathScores thoracicArteries()
{
    PathScores scores;
    const auto thorax = benchmarks::readThoracicScan();
    if (!thorax) {
        return scores;
    }
    core::CounterRandom random(17);
    for (const core::VesselBranch& branch : thorax->axes.branches) {
        if (branch.lengthMm() >= shortestMm) {
            tracePath(thorax->scan, branch, 1.5, random, scores);
        }
    }
    return scores;
}

}   // namespace

int main(int count, char** values)
{
    const benchmarks::Arguments arguments(count, values, usage);
    core::ResultTable table;
    table.title = "One vessel between two places, clicked half a voxel beside its axis; overlap with the true one";
    table.columns = {"vessels",       "overlap 0.9 or more", "none found",    "median",     "least",
                     "off axis [mm]", "radius error",        "processor [s]", "longest [s]"};
    addRow(table, "simulated scans, 0.7 mm", simulatedScans(static_cast<int>(arguments.number("seeds", 4))));
    addRow(table, "coronary tree of a patient beside a filled ventricle, 0.4 mm, 400 HU", coronaries(400.0));
    addRow(table, "the same, 220 HU", coronaries(220.0));
    addRow(table, "arteries of the thoracic CTA, by its masks, 1.5 mm", thoracicArteries());
    std::printf("%s\n", io::toPlainText(table).c_str());
    return 0;
}
