#include "angiopose/vessel_tree.h"

#include "app/library/conversions.h"
#include "app/library/observer_adapter.h"
#include "core/vessel/chain_points.h"
#include "io/centerline2d_file.h"
#include "io/vessel_tree_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace angiopose::library {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Range of rows that belong to one branch or curve.
struct Run {
    int id = 0;
    std::size_t first = 0;
    std::size_t end = 0;
};

/// Splits the rows where the ID changes; throws if an ID occurs in separate ranges.
std::vector<Run> runsOf(const std::vector<int>& ids, const char* noun)
{
    std::vector<Run> runs;
    std::set<int> seen;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (i > 0 && ids[i] == ids[i - 1]) {
            runs.back().end = i + 1;
            continue;
        }
        if (!seen.insert(ids[i]).second) {
            throw Error("library.points-apart", "The points of " + std::string(noun) + " " + std::to_string(ids[i]) +
                                                    " are not contiguous. Sort the rows by " + noun + ".");
        }
        runs.push_back({ids[i], i, i + 1});
    }
    return runs;
}

void checkLength(std::size_t length, std::size_t points, const char* name)
{
    if (length != points) {
        throw Error("library.lengths-differ", std::string(name) + " has " + std::to_string(length) +
                                                  " rows, but there are " + std::to_string(points) +
                                                  " points. Give one row per point.");
    }
}

/// Returns the radii of a range of rows; empty if all are unknown.
std::vector<double> radiiOf(const std::vector<double>& radii, const Run& run)
{
    if (radii.empty()) {
        return {};
    }
    const auto first = radii.begin() + static_cast<std::ptrdiff_t>(run.first);
    const auto end = radii.begin() + static_cast<std::ptrdiff_t>(run.end);
    const bool isKnown = std::any_of(first, end, [](double radius) { return !std::isnan(radius); });
    return isKnown ? std::vector<double>(first, end) : std::vector<double>();
}

template <class Point>
std::vector<Point> pointsOf(const std::vector<Point>& points, const Run& run)
{
    return {points.begin() + static_cast<std::ptrdiff_t>(run.first),
            points.begin() + static_cast<std::ptrdiff_t>(run.end)};
}

/// Appends the radii of a branch or curve with `count` points.
void append(std::vector<double>& all, const std::vector<double>& radii, std::size_t count)
{
    all.insert(all.end(), radii.begin(), radii.end());
    all.insert(all.end(), count - radii.size(), unknown);
}

/// Clears the array if all radii are unknown.
void clearIfUnknown(std::vector<double>& radii)
{
    if (std::all_of(radii.begin(), radii.end(), [](double radius) { return std::isnan(radius); })) {
        radii.clear();
    }
}

}   // namespace

core::VesselTree toCore(const VesselTree& tree)
{
    checkLength(tree.branchIds.size(), tree.points.size(), "branchIds");
    if (!tree.radiusMm.empty()) {
        checkLength(tree.radiusMm.size(), tree.points.size(), "radiusMm");
    }
    core::VesselTree converted;
    for (const Run& run : runsOf(tree.branchIds, "branch")) {
        core::VesselBranch branch{run.id, {}, pointsOf(tree.points, run), radiiOf(tree.radiusMm, run)};
        const auto label = std::ranges::find(tree.labels, run.id, &BranchLabel::id);
        if (label != tree.labels.end()) {
            branch.name = label->name;
            branch.generation = label->generation;
        }
        converted.branches.push_back(std::move(branch));
    }
    return converted;
}

core::Centerline2d toCore(const Centerline2d& centerline)
{
    const std::size_t count = centerline.points.size();
    if (centerline.curveIds.empty() && !centerline.radiusPx.empty()) {
        throw Error("library.radii-without-curves",
                    "The radii of image points are given along curves. Give curveIds too, or omit radiusPx.");
    }
    if (centerline.curveIds.empty()) {
        return core::chainPoints(centerline.points);
    }
    checkLength(centerline.curveIds.size(), count, "curveIds");
    if (!centerline.radiusPx.empty()) {
        checkLength(centerline.radiusPx.size(), count, "radiusPx");
    }
    core::Centerline2d converted;
    for (const Run& run : runsOf(centerline.curveIds, "curve")) {
        converted.curves.push_back({run.id, pointsOf(centerline.points, run), radiiOf(centerline.radiusPx, run)});
    }
    return converted;
}

VesselTree toPublic(const core::VesselTree& tree)
{
    VesselTree converted;
    for (const core::VesselBranch& branch : tree.branches) {
        const auto& points = branch.pointsInPatient;
        converted.points.insert(converted.points.end(), points.begin(), points.end());
        converted.branchIds.insert(converted.branchIds.end(), points.size(), branch.id);
        append(converted.radiusMm, branch.radiusMm, points.size());
        if (!branch.name.empty() || branch.generation >= 0) {
            converted.labels.push_back({branch.id, branch.name, branch.generation});
        }
    }
    clearIfUnknown(converted.radiusMm);
    return converted;
}

Centerline2d toPublic(const core::Centerline2d& centerline)
{
    Centerline2d converted;
    for (const core::Curve2d& curve : centerline.curves) {
        converted.points.insert(converted.points.end(), curve.pointsPx.begin(), curve.pointsPx.end());
        converted.curveIds.insert(converted.curveIds.end(), curve.pointsPx.size(), curve.id);
        append(converted.radiusPx, curve.radiusPx, curve.pointsPx.size());
    }
    clearIfUnknown(converted.radiusPx);
    return converted;
}

}   // namespace angiopose::library

namespace angiopose {

VesselTree readVesselTree(const std::string& path, double unitMm)
{
    io::VesselTreeReadOptions options;
    options.unitMm = unitMm;
    return library::toPublic(library::valueOf(io::readVesselTree(path, options)));
}

void writeVesselTree(const VesselTree& tree, const std::string& path)
{
    library::check(io::writeVesselTree(library::toCore(tree), path));
}

Centerline2d readCenterline2d(const std::string& path)
{
    return library::toPublic(library::valueOf(io::readCenterline2d(path)));
}

void writeCenterline2d(const Centerline2d& centerline, const std::string& path)
{
    library::check(io::writeCenterline2d(library::toCore(centerline), path));
}

}   // namespace angiopose
