// Prints how well and how fast vessels of CT angiograms are traced: simulated scans with known trees, the thoracic CTA
// with vessel masks, the CT of a stented abdominal aorta, and a large scan for time and memory.

#include "core/simulation/simulate_cta.h"
#include "core/tracing/volume/trace_vessels.h"
#include "io/volume_file.h"
#include "tests/benchmark/arguments.h"
#include "tests/support/test_data.h"
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

const std::string usage =
    "Usage: vessel_tracing_table [--simulated ] [--real ] [--large ] [--seeds <n>]\n"
    "  Without a choice all three parts are printed; --seeds: simulated scans (8).\n";

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

core::Volume readScan(const std::string& relative)
{
    auto read = io::readVolume(test::dataFile(relative).string());
    if (!read) {
        std::printf("%s\n", read.error().message.c_str());
        return {};
    }
    return std::move(read).value().volume;
}

/// The given arteries of the thoracic CTA as labels 1, 2, …; label 0 elsewhere.
core::LabelVolume givenArteries()
{
    core::LabelVolume all;
    std::uint16_t label = 0;
    for (const char* name : {"aorta", "brachiocephalic_trunk", "common_carotid_artery_left", "subclavian_artery_left",
                             "celiac_trunk", "superior_mesenteric_artery"}) {
        const core::Volume mask = readScan(std::string("thoracic-aorta-cta/") + name + ".nii.gz");
        if (all.voxels.empty()) {
            all = core::LabelVolume(mask.geometry);
        }
        ++label;
        for (std::size_t v = 0; v < mask.voxels.size(); ++v) {
            all.voxels[v] = mask.voxels[v] != 0 ? label : all.voxels[v];
        }
    }
    return all;
}

bool isInside(const core::LabelVolume& labels, const Eigen::Vector3d& point)
{
    const Eigen::Vector3i voxel = (labels.geometry.patientFromVoxel().inverse() * point).array().round().cast<int>();
    return labels.geometry.contains(voxel) && labels.at(voxel.x(), voxel.y(), voxel.z()) != 0;
}

/// A stretch of a branch outside the masks.
struct OutsideRun {
    int branch = 0;
    double lengthMm = 0.0;
    double radiusMm = 0.0;   ///< median, as are the values
    double value = 0.0;
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
    Eigen::Vector3d to = Eigen::Vector3d::Zero();
};

constexpr double sampleMm = 0.5;

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return values.empty() ? 0.0 : *middle;
}

double valueAt(const core::Volume& scan, const Eigen::Vector3d& point)
{
    const Eigen::Vector3i voxel = (scan.geometry.patientFromVoxel().inverse() * point).array().round().cast<int>();
    const Eigen::Vector3i at = voxel.cwiseMax(0).cwiseMin((scan.geometry.size.array() - 1).matrix());
    return scan.value(scan.geometry.index(at.x(), at.y(), at.z()));
}

OutsideRun runOf(const core::VesselBranch& branch, std::size_t first, std::size_t last, const core::Volume& scan)
{
    std::vector<double> values;
    for (std::size_t i = first; i < last; ++i) {
        values.push_back(valueAt(scan, branch.pointsInPatient[i]));
    }
    const auto radii = branch.radiusMm.begin();
    return {branch.id,
            sampleMm * static_cast<double>(last - first),
            medianOf({radii + static_cast<std::ptrdiff_t>(first), radii + static_cast<std::ptrdiff_t>(last)}),
            medianOf(values),
            branch.pointsInPatient[first],
            branch.pointsInPatient[last - 1]};
}

/// Where a curve runs, masked or not.
struct Course {
    double insideMm = 0.0;
    double insideValue = 0.0;   ///< median
    std::vector<OutsideRun> outside;
    std::vector<Eigen::Vector3d> insidePoints;
};

Course courseOf(const core::VesselTree& tree, const core::LabelVolume& labels, const core::Volume& scan)
{
    Course course;
    std::vector<double> values;
    for (const core::VesselBranch& branch : core::resampled(tree, sampleMm).branches) {
        const auto& way = branch.pointsInPatient;
        for (std::size_t i = 0; i < way.size();) {
            const std::size_t first = i;
            const bool isIn = isInside(labels, way[i]);
            while (i < way.size() && isInside(labels, way[i]) == isIn) {
                ++i;
            }
            if (!isIn) {
                course.outside.push_back(runOf(branch, first, i, scan));
                continue;
            }
            for (std::size_t n = first; n < i; ++n) {
                course.insidePoints.push_back(way[n]);
                values.push_back(valueAt(scan, way[n]));
            }
        }
    }
    course.insideMm = sampleMm * static_cast<double>(course.insidePoints.size());
    course.insideValue = medianOf(values);
    return course;
}

/// Share of the masks' axes beside which the curve runs within the masks. The axis of an aorta with two lumens lies
/// between them, so that a distance to it would say nothing.
double coveredShare(const core::VesselTree& axes, const std::vector<Eigen::Vector3d>& insidePoints)
{
    constexpr double reachMm = 2.0;   // along the axis
    std::vector<Eigen::Vector3d> axis;
    for (const core::VesselBranch& branch : core::resampled(axes, sampleMm).branches) {
        axis.insert(axis.end(), branch.pointsInPatient.begin(), branch.pointsInPatient.end());
    }
    std::vector<bool> isBeside(axis.size(), false);
    for (const Eigen::Vector3d& point : insidePoints) {
        const auto nearest = std::min_element(axis.begin(), axis.end(), [&](const auto& a, const auto& b) {
            return (a - point).squaredNorm() < (b - point).squaredNorm();
        });
        isBeside[static_cast<std::size_t>(nearest - axis.begin())] = true;
    }
    std::size_t covered = 0;
    for (const Eigen::Vector3d& point : axis) {
        for (std::size_t n = 0; n < axis.size(); ++n) {
            if (isBeside[n] && (axis[n] - point).norm() <= reachMm) {
                ++covered;
                break;
            }
        }
    }
    return static_cast<double>(covered) / std::max(1.0, static_cast<double>(axis.size()));
}

/// As bright as the masked arteries are: a vessel that the masks leave out.
bool isArterial(const OutsideRun& run, const Course& course)
{
    return std::abs(run.value - course.insideValue) <= 0.1 * course.insideValue;
}

Course addThoracic(Table& table, const std::string& name, const core::Result<core::TracedVessels>& traced,
                   const core::LabelVolume& arteries, const core::VesselTree& axes, const core::Volume& scan)
{
    if (!traced) {
        table.add({name, traced.error().message});
        return {};
    }
    const core::VesselTree& tree = traced.value().tree;
    Course course = courseOf(tree, arteries, scan);
    double arterialMm = 0.0;
    double otherMm = 0.0;
    for (const OutsideRun& run : course.outside) {
        (isArterial(run, course) ? arterialMm : otherMm) += run.lengthMm;
    }
    const double all = course.insideMm + arterialMm + otherMm;
    table.add({name, fixed(course.insideMm / all, 3), fixed(arterialMm / all, 3), fixed(otherMm / all, 3),
               fixed(coveredShare(axes, course.insidePoints), 3), std::to_string(tree.branches.size()), fixed(all, 0)});
    return course;
}

std::string placeOf(const Eigen::Vector3d& point, const core::Volume& scan)
{
    const Eigen::Vector3d voxel = scan.geometry.patientFromVoxel().inverse() * point;
    return fixed(voxel.x(), 0) + " " + fixed(voxel.y(), 0) + " " + fixed(voxel.z(), 0);
}

void printOutside(const Course& course, const core::Volume& scan)
{
    Table table({"one seed, outside the masks: branch", "length [mm]", "radius [mm]", "HU", "as arteries", "from voxel",
                 "to voxel"});
    for (const OutsideRun& run : course.outside) {
        if (run.lengthMm >= 2.0) {
            table.add({std::to_string(run.branch), fixed(run.lengthMm, 1), fixed(run.radiusMm, 1), fixed(run.value, 0),
                       isArterial(run, course) ? "yes" : "no", placeOf(run.from, scan), placeOf(run.to, scan)});
        }
    }
    table.print();
}

void printThoracic()
{
    const core::Volume scan = readScan("thoracic-aorta-cta/ct_cropped.nii.gz");
    const core::LabelVolume arteries = givenArteries();
    // The masks are a network's, with stubs on their walls that are no vessels.
    const auto axes = core::traceLabels(arteries, {}, {.minBranchLengthMm = 12.0});
    if (scan.voxels.empty() || !axes) {
        return;
    }
    const Eigen::Affine3d patientFromVoxel = scan.geometry.patientFromVoxel();
    const auto at = [&](int i, int j, int k) { return (patientFromVoxel * Eigen::Vector3d(i, j, k)).eval(); };
    const core::VesselTree& masks = axes.value().tree;
    Table table({"thoracic CTA", "inside masks", "outside, as bright", "outside, other", "masks covered", "branches",
                 "length [mm]"});
    addThoracic(table, "from the masks", axes, arteries, masks, scan);
    // Clicks into the ascending aorta; into ventricle, atria, pulmonary artery, superior vena cava and the
    // brachiocephalic vein before and beside the arch.
    core::VesselTracingOptions options;
    options.seedsInPatient = {at(51, 48, 107)};
    options.rootInPatient = at(52, 48, 85);
    const Course course = addThoracic(table, "one seed", core::traceVessels(scan, options), arteries, masks, scan);
    options.avoidInPatient = {at(48, 73, 82), at(75, 54, 62),  at(75, 45, 85),  at(36, 67, 92), at(67, 28, 85),
                              at(36, 31, 80), at(38, 47, 110), at(64, 52, 131), at(45, 45, 133)};
    addThoracic(table, "seed, heart and veins avoided", core::traceVessels(scan, options), arteries, masks, scan);
    table.print();
    printOutside(course, scan);
}

void printStent()
{
    const core::Volume scan = readScan("abdominal-aorta-stent-ct/stent.nrrd");
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
    const bool isAll = !arguments.isSet("simulated") && !arguments.isSet("real") && !arguments.isSet("large");
    if (isAll || arguments.isSet("simulated")) {
        printSimulated(static_cast<int>(arguments.number("seeds", 8)));
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
