// Prints how well tracing finds thin arteries next to structures of the same brightness: coronary arteries on opacified
// hearts, hepatic arteries next to the portal vein, the circle of Willis above the skull base; with the defaults, from
// the seeds that a user would place, and as thin vessels from these seeds. Simulated bodies, and coronary trees of a
// patient.

#include "core/evaluation/report/result_table.h"
#include "core/support/format_number.h"
#include "core/support/quantile.h"
#include "core/tracing/volume/trace_vessels.h"
#include "io/evaluation/table_text.h"
#include "io/volume_file.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/drawn_heart.h"
#include "tests/benchmark/timing.h"
#include "tests/support/bodies/simulate_body.h"
#include "tests/support/tree_agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

using namespace angiopose;

namespace {

const char* const usage =
    "body_table [--seeds <n>] [--first <seed>] [--body <list>] [--asked <list>] [--save <folder>]\n"
    "  --seeds <n>      simulated bodies of each kind (3)\n"
    "  --first <seed>   of the first (1); thresholds are chosen from 101 on\n"
    "  --asked <list>   of defaults, seeds, thin (all)\n"
    "  --body <list>    of heart, liver, head, patient (all)\n"
    "  --save <folder>  writes the simulated scans there, to be looked at\n";

constexpr double widestCoronaryMm = 3.5;
constexpr std::size_t clickedAfterMm = 10;   // distance along a coronary artery at which a user recognizes it

struct Asking {
    const char* option;
    const char* name;
    bool hasSeeds;
    bool tubesOnly;
};

constexpr Asking askings[]{{"defaults", "defaults", false, false},
                           {"seeds", "from seeds", true, false},
                           {"thin", "thin vessels from seeds", true, true}};

struct Scores {
    std::vector<double> overlap, found, falseShare, distanceMm, radiusError, walls;
    int refused = 0;
};

core::ResultTable tableOf()
{
    core::ResultTable table;
    table.columns = {"vessels", "asked for",    "scans",         "nothing",      "overlap",
                     "found",   "false length", "off axis [mm]", "radius error", "wall [s]"};
    return table;
}

void addScores(core::ResultTable& table, const std::string& body, const Asking& asking, const Scores& scores)
{
    const auto medianText = [](const std::vector<double>& values, int places) {
        return values.empty() ? std::string("-") : core::fixedText(core::medianOf(values), places);
    };
    const auto scans = scores.overlap.size() + static_cast<std::size_t>(scores.refused);
    table.rows.push_back(
        {{body, asking.name, std::to_string(scans), std::to_string(scores.refused), medianText(scores.overlap, 3),
          medianText(scores.found, 3), medianText(scores.falseShare, 3), medianText(scores.distanceMm, 2),
          medianText(scores.radiusError, 3), medianText(scores.walls, 1)},
         false});
}

void trace(const core::BodyScan& scan, const Asking& asking, Scores& scores)
{
    core::VesselTracingOptions options;
    options.tubesOnly = asking.tubesOnly;
    if (asking.hasSeeds) {
        options.seedsInPatient = scan.origins;
    }
    std::optional<core::Result<core::TracedVessels>> traced;
    scores.walls.push_back(benchmarks::timed([&] { traced = core::traceVessels(scan.volume, options); }).wall);
    if (!*traced) {
        ++scores.refused;
        return;
    }
    const double voxelMm = std::cbrt(scan.volume.geometry.spacingMm.prod());
    const auto agreement = test::agreementOf(traced->value().tree, scan.arteries, voxelMm);
    scores.overlap.push_back(agreement.overlap);
    scores.found.push_back(agreement.found);
    scores.falseShare.push_back(1.0 - agreement.right);
    scores.distanceMm.push_back(agreement.meanDistanceMm);
    scores.radiusError.push_back(agreement.radiusError);
}

void addBody(core::ResultTable& table, const std::string& name, const std::vector<core::BodyScan>& scans,
             const std::vector<std::string>& asked)
{
    for (const Asking& asking : askings) {
        if (std::ranges::find(asked, asking.option) == asked.end()) {
            continue;
        }
        Scores scores;
        for (const core::BodyScan& scan : scans) {
            trace(scan, asking, scores);
        }
        addScores(table, name, asking, scores);
    }
}

/// The segments of a tree that are no wider than coronary arteries; the lines in the file begin in the aorta.
core::VesselTree thinPart(const core::VesselTree& tree)
{
    core::VesselTree thin;
    for (const core::VesselBranch& branch : tree.branches) {
        core::VesselBranch part;
        part.id = branch.id;
        for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
            if (branch.radiusMm[n] <= widestCoronaryMm) {
                part.pointsInPatient.push_back(branch.pointsInPatient[n]);
                part.radiusMm.push_back(branch.radiusMm[n]);
            } else {
                part.pointsInPatient.clear();   // everything up to here is the aorta
                part.radiusMm.clear();
            }
        }
        if (part.pointsInPatient.size() > 1) {
            thin.branches.push_back(std::move(part));
        }
    }
    return thin;
}

std::vector<core::BodyScan> patientHearts(double bloodHu)
{
    std::vector<core::BodyScan> scans;
    for (const char* side : {"lca", "rca"}) {
        const core::VesselTree whole = benchmarks::coronaryTree(side);
        core::BodyScan scan;
        scan.arteries = thinPart(whole);
        if (!scan.arteries.branches.empty()) {
            scan.volume = benchmarks::drawnHeart(whole, bloodHu);
            core::VesselTree trunk;
            trunk.branches = {scan.arteries.branches.front()};
            const auto places = core::resampled(trunk, 1.0).branches.front().pointsInPatient;
            scan.origins = {places[std::min(clickedAfterMm, places.size() - 1)]};
            scans.push_back(std::move(scan));
        }
    }
    return scans;
}

}   // namespace

int main(int count, char** values)
{
    const benchmarks::Arguments arguments(count, values, usage);
    const int seeds = static_cast<int>(arguments.number("seeds", 3));
    const int firstSeed = static_cast<int>(arguments.number("first", 1));
    const std::vector<std::string> asked = arguments.list("asked", "defaults,seeds,thin");
    const std::string folder = arguments.text("save", "");
    core::ResultTable table = tableOf();
    table.title = "Thin arteries beside what is as bright, medians";
    for (const std::string& body : arguments.list("body", "heart,liver,head,patient")) {
        if (body == "patient") {
            addBody(table, "coronary trees of a patient, 400 HU", patientHearts(400.0), asked);
            addBody(table, "the same, 220 HU", patientHearts(220.0), asked);
            continue;
        }
        std::vector<core::BodyScan> scans;
        for (int seed = firstSeed; seed < firstSeed + seeds; ++seed) {
            const auto number = static_cast<std::uint64_t>(seed);
            scans.push_back(body == "heart"   ? core::simulateHeart(number)
                            : body == "liver" ? core::simulateLiver(number)
                                              : core::simulateHead(number));
            if (!folder.empty()) {
                const auto written =
                    io::writeVolume(scans.back().volume, folder + "/" + body + std::to_string(seed) + ".nii.gz");
                std::printf("%s", written ? "" : (written.error().message.text() + "\n").c_str());
            }
        }
        addBody(table, "simulated " + body, scans, asked);
    }
    std::printf("%s\n", io::toPlainText(table).c_str());
    return 0;
}
