// Prints how well and how fast vessels of CT angiograms are traced: simulated scans with known trees, the thoracic CTA
// with vessel masks, the CT of a stented abdominal aorta, and a large scan for time and memory.

#include "core/simulation/simulate_cta.h"
#include "core/tracing/volume/trace_vessels.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/thoracic_scan.h"
#include "tests/support/tree_agreement.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace {

using benchmarks::Course;
using benchmarks::ThoracicScan;

const std::string usage =
    "Usage: vessel_tracing_table [--simulated ] [--stents ] [--real ] [--large ] [--seeds <n>]\n"
    "  Without a choice all four parts are printed; --seeds: simulated scans (8).\n";

std::string fixed(double value, int decimals)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

/// Rows below a head, as wide as they need.
class Table {
public:
    explicit Table(std::vector<std::string> head) { rows_.push_back(std::move(head)); }

    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

    void print() const
    {
        std::vector<std::size_t> widths(rows_.front().size(), 0);
        for (const auto& row : rows_) {
            for (std::size_t c = 0; row.size() == widths.size() && c < row.size(); ++c) {
                widths[c] = std::max(widths[c], row[c].size());
            }
        }
        for (const auto& row : rows_) {
            for (std::size_t c = 0; c < row.size(); ++c) {
                std::printf("%*s  ", static_cast<int>(widths[c]), row[c].c_str());
            }
            std::printf("\n");
        }
        std::printf("\n");
    }

private:
    std::vector<std::vector<std::string>> rows_;
};

/// Wall and processor time of one piece of work, s.
struct Timing {
    double wall = 0.0;
    double processor = 0.0;
};

template <class Work>
Timing timed(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t used = std::clock();
    work();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC};
}

/// The most memory that the program has held since `forgetPeak`, MB.
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

void printSimulated(int seeds)
{
    Table table(
        {"seed", "found", "right", "overlap", "distance [voxel]", "radius error", "branches", "true", "wall [s]"});
    for (int seed = 1; seed <= seeds; ++seed) {
        const core::SimulatedCta cta = core::simulateCta(static_cast<std::uint64_t>(seed));
        const double voxelMm = std::cbrt(cta.volume.geometry.spacingMm.prod());
        std::optional<core::Result<core::TracedVessels>> traced;
        const Timing time = timed([&] { traced = core::traceVessels(cta.volume); });
        if (!*traced) {
            table.add({std::to_string(seed), traced->error().message});
            continue;
        }
        const core::VesselTree& tree = traced->value().tree;
        const test::TreeAgreement agreement = test::agreementOf(tree, cta.tree, voxelMm);
        table.add({std::to_string(seed), fixed(agreement.found, 3), fixed(agreement.right, 3),
                   fixed(agreement.overlap, 3), fixed(agreement.meanDistanceMm / voxelMm, 3),
                   fixed(agreement.radiusError, 3), std::to_string(tree.branches.size()),
                   std::to_string(cta.tree.branches.size()), fixed(time.wall, 1)});
    }
    std::printf("Simulated CT angiograms, 256 x 256 x 220, defaults\n");
    table.print();
}

/// Simulated scans whose first branch carries a stent.
void printStented()
{
    Table table({"voxel [mm]", "stent radius [mm]", "found", "right", "error in stent [mm]", "branches", "true"});
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
                const std::string radius = fixed(stented.radiusMm[stented.radiusMm.size() / 2], 1);
                if (!traced) {
                    table.add(
                        {fixed(voxelMm, 2), radius, "-", "-", "-", "0", std::to_string(cta.tree.branches.size())});
                    continue;
                }
                const core::VesselTree& tree = traced.value().tree;
                const test::TreeAgreement agreement = test::agreementOf(tree, cta.tree, voxelMm);
                const auto error = test::radiusErrorInStentMm(tree, stented);
                table.add({fixed(voxelMm, 2), radius, fixed(agreement.found, 3), fixed(agreement.right, 3),
                           error ? fixed(*error, 2) : "not found", std::to_string(tree.branches.size()),
                           std::to_string(cta.tree.branches.size())});
            }
        }
    }
    std::printf("Simulated CT angiograms with a stent\n");
    table.print();
}

void addThoracic(Table& table, const std::string& name, const core::Result<core::TracedVessels>& traced,
                 const ThoracicScan& thorax)
{
    if (!traced) {
        table.add({name, traced.error().message});
        return;
    }
    const core::VesselTree& tree = traced.value().tree;
    const Course course = benchmarks::courseOf(tree, thorax);
    table.add({name, fixed(course.inside, 3), fixed(course.outsideArterial, 3), fixed(course.outsideOther, 3),
               fixed(course.covered, 3), std::to_string(tree.branches.size()), fixed(course.lengthMm, 0)});
}

std::string placeOf(const Eigen::Vector3d& point, const core::Volume& scan)
{
    const Eigen::Vector3d voxel = scan.geometry.patientFromVoxel().inverse() * point;
    return fixed(voxel.x(), 0) + " " + fixed(voxel.y(), 0) + " " + fixed(voxel.z(), 0);
}

void printOutside(const Course& course, const core::Volume& scan)
{
    Table table({"one seed, outside the masks: branch", "length [mm]", "radius [mm]", "HU", "as arteries",
                 "farthest [mm]", "from voxel", "to voxel"});
    for (const benchmarks::OutsideRun& run : course.outside) {
        if (run.lengthMm >= 2.0) {
            table.add({std::to_string(run.branch), fixed(run.lengthMm, 1), fixed(run.radiusMm, 1), fixed(run.value, 0),
                       run.isArterial ? "yes" : "no", fixed(run.farthestMm, 1), placeOf(run.from, scan),
                       placeOf(run.to, scan)});
        }
    }
    table.print();
}

/// Shares of the curve outside the masks, by how far away their runs lead and how bright they are.
void printReasons(const Course& course)
{
    struct Reason {
        const char* name;
        double mostMm;
        double arterialMm = 0.0;
        double otherMm = 0.0;
    };
    std::vector<Reason> reasons{{"within a voxel of the masks", 2.2},
                                {"within 5 mm: beside the masks, stumps", 5.0},
                                {"farther: vessels of their own", 1e9}};
    for (const benchmarks::OutsideRun& run : course.outside) {
        const auto its = std::find_if(reasons.begin(), reasons.end(),
                                      [&](const Reason& reason) { return run.farthestMm <= reason.mostMm; });
        (run.isArterial ? its->arterialMm : its->otherMm) += run.lengthMm;
    }
    Table table({"one seed, outside the masks", "as bright as arteries", "other"});
    for (const Reason& reason : reasons) {
        table.add(
            {reason.name, fixed(reason.arterialMm / course.lengthMm, 3), fixed(reason.otherMm / course.lengthMm, 3)});
    }
    table.print();
}

void printThoracic()
{
    const std::optional<ThoracicScan> read = benchmarks::readThoracicScan();
    if (!read) {
        return;
    }
    const ThoracicScan& thorax = *read;
    Table table({"thoracic CTA", "inside masks", "outside, as bright", "outside, other", "masks covered", "branches",
                 "length [mm]"});
    core::TracedVessels given;
    given.tree = thorax.axes;
    addThoracic(table, "from the masks", given, thorax);
    core::VesselTracingOptions options;
    options.seedsInPatient = {benchmarks::seedOf(thorax)};
    options.rootInPatient = benchmarks::rootOf(thorax);
    const auto fromSeed = core::traceVessels(thorax.scan, options);
    addThoracic(table, "one seed", fromSeed, thorax);
    // Clicks into ventricle, atria, pulmonary artery, superior vena cava and the brachiocephalic vein before and beside
    // the arch.
    options.avoidInPatient = {thorax.at(48, 73, 82),  thorax.at(75, 54, 62),  thorax.at(75, 45, 85),
                              thorax.at(36, 67, 92),  thorax.at(67, 28, 85),  thorax.at(36, 31, 80),
                              thorax.at(38, 47, 110), thorax.at(64, 52, 131), thorax.at(45, 45, 133)};
    addThoracic(table, "seed, heart and veins avoided", core::traceVessels(thorax.scan, options), thorax);
    table.print();
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
        std::printf("%s\n", traced->error().message.c_str());
        return;
    }
    Table table({"stent CT: branch", "generation", "length [mm]", "radius [mm]", "from slice", "to slice"});
    const Eigen::Affine3d voxelFromPatient = scan.geometry.patientFromVoxel().inverse();
    for (const core::VesselBranch& branch : traced->value().tree.branches) {
        std::vector<double> radii = branch.radiusMm;
        std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2), radii.end());
        if (branch.lengthMm() > 60.0) {
            table.add({std::to_string(branch.id), std::to_string(branch.generation), fixed(branch.lengthMm(), 0),
                       fixed(radii[radii.size() / 2], 1),
                       fixed((voxelFromPatient * branch.pointsInPatient.front()).z(), 0),
                       fixed((voxelFromPatient * branch.pointsInPatient.back()).z(), 0)});
        }
    }
    table.print();
    std::printf("%zu branches in all, those above 60 mm are shown; no seed; %.1f s\n\n",
                traced->value().tree.branches.size(), time.wall);
}

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
    const Timing time = timed([&] {
        const auto traced = core::traceVessels(scan);
        branches = traced ? traced.value().tree.branches.size() : 0;
    });
    std::printf(
        "512 x 512 x 300 (%.0f MB): %zu branches, wall %.1f s, processor %.1f s, peak memory %.2f x the volume "
        "(volume included)\n",
        volumeMb, branches, time.wall, time.processor, (peakMb() - before + volumeMb) / volumeMb);
}

/// Stop pressed at ten times of the run: how long until the tracer has returned.
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
            return passed() >= pressed ? core::Verdict::Stop : core::Verdict::Continue;
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
        const core::SimulatedCta cta = largeScan();
        printLarge(cta.volume);
        printStops(cta.volume, {}, "no seed");
        printStops(cta.volume, {.seedsInPatient = {cta.tree.branches.front().pointsInPatient[5]}}, "one seed");
    }
    return 0;
}
