// Prints the quality and speed of vessel tracing in CT angiograms: simulated scans with known trees, the thoracic CTA
// with vessel masks, the CT of a stented abdominal aorta, and a large scan for time and memory.

#include "core/evaluation/report/result_table.h"
#include "core/simulation/simulate_cta.h"
#include "core/support/format_number.h"
#include "core/tracing/volume/trace_vessels.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/large_scan.h"
#include "tests/benchmark/thoracic_course.h"
#include "tests/benchmark/thoracic_scan.h"
#include "tests/benchmark/timing.h"
#include "tests/support/tree_agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace angiopose;

namespace {

using benchmarks::Course;
using benchmarks::ThoracicScan;
using benchmarks::timed;
using benchmarks::Timing;
using core::fixedText;

const std::string usage =
    "Usage: vessel_tracing_table [--simulated ] [--stents ] [--real ] [--large ] [--seeds <n>]\n"
    "  Without a choice all four parts are printed; --seeds: simulated scans (8).\n";

core::ResultTable tableOf(std::vector<std::string> columns)
{
    core::ResultTable table;
    table.columns = std::move(columns);
    return table;
}

/// Adds a row; missing cells stay empty.
void add(core::ResultTable& table, std::vector<std::string> cells)
{
    cells.resize(table.columns.size());
    table.rows.push_back({std::move(cells), false});
}

void print(const core::ResultTable& table)
{
    std::printf("%s\n", io::toPlainText(table).c_str());
}

void printSimulated(int seeds)
{
    core::ResultTable table = tableOf(
        {"seed", "found", "right", "overlap", "distance [voxel]", "radius error", "branches", "true", "wall [s]"});
    for (int seed = 1; seed <= seeds; ++seed) {
        const core::SimulatedCta cta = core::simulateCta(static_cast<std::uint64_t>(seed));
        const double voxelMm = std::cbrt(cta.volume.geometry.spacingMm.prod());
        std::optional<core::Result<core::TracedVessels>> traced;
        const Timing time = timed([&] { traced = core::traceVessels(cta.volume); });
        if (!*traced) {
            add(table, {std::to_string(seed) + ": " + traced->error().message.text()});
            continue;
        }
        const core::VesselTree& tree = traced->value().tree;
        const test::TreeAgreement agreement = test::agreementOf(tree, cta.tree, voxelMm);
        add(table, {std::to_string(seed), fixedText(agreement.found, 3), fixedText(agreement.right, 3),
                    fixedText(agreement.overlap, 3), fixedText(agreement.meanDistanceMm / voxelMm, 3),
                    fixedText(agreement.radiusError, 3), std::to_string(tree.branches.size()),
                    std::to_string(cta.tree.branches.size()), fixedText(time.wall, 1)});
    }
    table.title = "Simulated CT angiograms, 256 x 256 x 220, defaults";
    print(table);
}

void printStented()
{
    core::ResultTable table =
        tableOf({"voxel [mm]", "stent radius [mm]", "found", "right", "error in stent [mm]", "branches", "true"});
    for (const double voxelMm : {1.0, 0.75, 0.6}) {
        for (const double rootRadiusMm : {3.0, 4.0, 5.0, 6.5, 8.0}) {
            for (const std::uint64_t seed : {1U, 2U}) {
                const int across = static_cast<int>(120.0 / voxelMm);
                const core::SimulatedCta cta = core::simulateCta(seed, {.branchCount = 6, .rootRadiusMm = rootRadiusMm},
                                                                 {.size = {across, across, across},
                                                                  .spacingMm = Eigen::Vector3d::Constant(voxelMm),
                                                                  .calcificationCount = 4,
                                                                  .hasStent = true});
                const auto traced = core::traceVessels(cta.volume);
                const core::VesselBranch& stented = cta.tree.branches.front();
                const std::string radius = fixedText(stented.radiusMm[stented.radiusMm.size() / 2], 1);
                if (!traced) {
                    add(table,
                        {fixedText(voxelMm, 2), radius, "-", "-", "-", "0", std::to_string(cta.tree.branches.size())});
                    continue;
                }
                const core::VesselTree& tree = traced.value().tree;
                const test::TreeAgreement agreement = test::agreementOf(tree, cta.tree, voxelMm);
                const auto error = test::radiusErrorInStentMm(tree, stented);
                add(table, {fixedText(voxelMm, 2), radius, fixedText(agreement.found, 3), fixedText(agreement.right, 3),
                            error ? fixedText(*error, 2) : "not found", std::to_string(tree.branches.size()),
                            std::to_string(cta.tree.branches.size())});
            }
        }
    }
    table.title = "Simulated CT angiograms with a stent";
    print(table);
}

void addThoracic(core::ResultTable& table, const std::string& name, const core::Result<core::TracedVessels>& traced,
                 const ThoracicScan& thorax)
{
    if (!traced) {
        add(table, {name + ": " + traced.error().message.text()});
        return;
    }
    const core::VesselTree& tree = traced.value().tree;
    const Course course = benchmarks::courseOf(tree, thorax);
    add(table, {name, fixedText(course.inside, 3), fixedText(course.outsideArterial, 3),
                fixedText(course.outsideOther, 3), fixedText(course.insideOfJudged, 3), fixedText(course.covered, 3),
                std::to_string(tree.branches.size()), fixedText(course.lengthMm, 0)});
}

std::string placeOf(const Eigen::Vector3d& point, const core::Volume& scan)
{
    const Eigen::Vector3d voxel = scan.geometry.patientFromVoxel().inverse() * point;
    return fixedText(voxel.x(), 0) + " " + fixedText(voxel.y(), 0) + " " + fixedText(voxel.z(), 0);
}

std::string textOf(benchmarks::OutsideKind kind)
{
    switch (kind) {
        case benchmarks::OutsideKind::BothLumens:
            return "mask of a lumen";
        case benchmarks::OutsideKind::BeyondAnEnd:
            return "beyond an end";
        case benchmarks::OutsideKind::Elsewhere:
            return "elsewhere";
    }
    return {};
}

void printOutside(const Course& course, const core::Volume& scan)
{
    core::ResultTable table = tableOf({"one seed, outside the masks: branch", "length [mm]", "radius [mm]", "HU",
                                       "as arteries", "farthest [mm]", "where", "from voxel", "to voxel"});
    for (const benchmarks::OutsideRun& run : course.outside) {
        if (run.lengthMm >= 2.0) {
            add(table, {std::to_string(run.branch), fixedText(run.lengthMm, 1), fixedText(run.radiusMm, 1),
                        fixedText(run.value, 0), run.isArterial ? "yes" : "no", fixedText(run.farthestMm, 1),
                        textOf(run.kind), placeOf(run.from, scan), placeOf(run.to, scan)});
        }
    }
    print(table);
}

/// Prints the shares of the curve outside the masks by the distance that its segments reach and by their brightness.
void printReasons(const Course& course)
{
    struct Reason {
        const char* name;
        double maxMm;
        double arterialMm = 0.0;
        double otherMm = 0.0;
    };
    std::vector<Reason> reasons{{"within a voxel of the masks", 2.2},
                                {"within 5 mm: beside the masks, stumps", 5.0},
                                {"farther: vessels of their own", 1e9}};
    for (const benchmarks::OutsideRun& run : course.outside) {
        const auto its = std::find_if(reasons.begin(), reasons.end(),
                                      [&](const Reason& reason) { return run.farthestMm <= reason.maxMm; });
        (run.isArterial ? its->arterialMm : its->otherMm) += run.lengthMm;
    }
    core::ResultTable table = tableOf({"one seed, outside the masks", "as bright as arteries", "other"});
    for (const Reason& reason : reasons) {
        add(table, {reason.name, fixedText(reason.arterialMm / course.lengthMm, 3),
                    fixedText(reason.otherMm / course.lengthMm, 3)});
    }
    print(table);
}

void printThoracic()
{
    const std::optional<ThoracicScan> read = benchmarks::readThoracicScan();
    if (!read) {
        return;
    }
    const ThoracicScan& thorax = *read;
    core::ResultTable table = tableOf({"thoracic CTA", "inside masks", "outside, as bright", "outside, other",
                                       "inside of judged", "masks covered", "branches", "length [mm]"});
    core::TracedVessels given;
    given.tree = thorax.axes;
    addThoracic(table, "axes of the masks", given, thorax);
    addThoracic(table, "masks as labels, defaults", core::traceLabels(thorax.arteries, {}), thorax);
    addThoracic(table, "no seed", core::traceVessels(thorax.scan), thorax);
    core::VesselTracingOptions options;
    options.seedsInPatient = {benchmarks::seedOf(thorax)};
    options.rootInPatient = benchmarks::rootOf(thorax);
    const auto fromSeed = core::traceVessels(thorax.scan, options);
    addThoracic(table, "one seed", fromSeed, thorax);
    // Seeds in the ventricle, atria, pulmonary artery, superior vena cava and the brachiocephalic vein, in front of and
    // beside the arch.
    options.avoidInPatient = {thorax.at(48, 73, 82),  thorax.at(75, 54, 62),  thorax.at(75, 45, 85),
                              thorax.at(36, 67, 92),  thorax.at(67, 28, 85),  thorax.at(36, 31, 80),
                              thorax.at(38, 47, 110), thorax.at(64, 52, 131), thorax.at(45, 45, 133)};
    addThoracic(table, "seed, heart and veins avoided", core::traceVessels(thorax.scan, options), thorax);
    print(table);
    std::printf(
        "Inside of judged: the masks end where arteries go on, and leave out parts of the torn aorta. What is "
        "reached through an end of\na mask (within twice its radius) is not judged, and the masks of the aorta's "
        "two lumens count as inside; all else does not.\n\n");
    if (fromSeed) {
        const Course course = benchmarks::courseOf(fromSeed.value().tree, thorax);
        printReasons(course);
        printOutside(course, thorax.scan);
    }
}

void printStent()
{
    const core::Volume scan = benchmarks::readScan("abdominal-aorta-stent-ct/stent.nrrd");
    if (scan.voxels.empty()) {
        return;
    }
    std::optional<core::Result<core::TracedVessels>> traced;
    const Timing time = timed([&] { traced = core::traceVessels(scan); });
    if (!*traced) {
        std::printf("%s\n", traced->error().message.text().c_str());
        return;
    }
    core::ResultTable table =
        tableOf({"stent CT: branch", "generation", "length [mm]", "radius [mm]", "from slice", "to slice"});
    const Eigen::Affine3d voxelFromPatient = scan.geometry.patientFromVoxel().inverse();
    for (const core::VesselBranch& branch : traced->value().tree.branches) {
        std::vector<double> radii = branch.radiusMm;
        std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2), radii.end());
        if (branch.lengthMm() > 60.0) {
            add(table, {std::to_string(branch.id), std::to_string(branch.generation), fixedText(branch.lengthMm(), 0),
                        fixedText(radii[radii.size() / 2], 1),
                        fixedText((voxelFromPatient * branch.pointsInPatient.front()).z(), 0),
                        fixedText((voxelFromPatient * branch.pointsInPatient.back()).z(), 0)});
        }
    }
    print(table);
    std::printf("%zu branches in all, those above 60 mm are shown; no seed; %.1f s\n\n",
                traced->value().tree.branches.size(), time.wall);
}

}   // namespace

int main(int count, char** values)
{
    const benchmarks::Arguments arguments(count, values, usage);
    const bool isAll = !arguments.isSet("simulated") && !arguments.isSet("stents") && !arguments.isSet("real") &&
                       !arguments.isSet("large");
    if (isAll || arguments.isSet("simulated")) {
        printSimulated(static_cast<int>(arguments.number("seeds", 8)));
    }
    if (isAll || arguments.isSet("stents")) {
        printStented();
    }
    if (isAll || arguments.isSet("real")) {
        printThoracic();
        printStent();
    }
    if (isAll || arguments.isSet("large")) {
        benchmarks::printLargeScan();
    }
    return 0;
}
