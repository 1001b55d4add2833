#include "tests/benchmark/graph_trees.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include "core/simulation/simulated_case.h"

namespace angiopose::benchmarks {
namespace {

constexpr double voxelMm = 0.45;   // not recorded with the graphs; the arteries of a brain span about 130 mm
constexpr double maxTortuous = 1.45;   // length over chord; larger values come from zigzag tracing

Eigen::Vector3d anyDirection(core::CounterRandom& random)
{
    return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

/// An arch over the chord with an added wave.
std::vector<Eigen::Vector3d> arched(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double lengthMm,
                                    core::CounterRandom& random)
{
    const Eigen::Vector3d chord = to - from;
    const Eigen::Vector3d up = chord.cross(anyDirection(random)).normalized();
    const Eigen::Vector3d side = chord.cross(up).normalized();
    const double wave = random.uniform(0.2, 0.5);
    const auto curve = [&](double height) {
        const auto count = static_cast<int>(std::ceil(lengthMm)) + 1;
        std::vector<Eigen::Vector3d> points;
        for (int k = 0; k <= count; ++k) {
            const double t = static_cast<double>(k) / count;
            points.push_back(from + t * chord + height * std::sin(std::numbers::pi * t) * up +
                             wave * height * std::sin(2.0 * std::numbers::pi * t) * side);
        }
        return points;
    };
    const auto lengthOf = [](const std::vector<Eigen::Vector3d>& points) {
        core::VesselBranch branch;
        branch.pointsInPatient = points;
        return branch.lengthMm();
    };
    double low = 0.0;
    double high = lengthMm;
    for (int k = 0; k < 30; ++k) {
        const double middle = 0.5 * (low + high);
        (lengthOf(curve(middle)) < lengthMm ? low : high) = middle;
    }
    return curve(low);
}

}   // namespace

core::VesselTree graphTree(int number, core::CounterRandom random)
{
    const ArteryGraph graph = readArteryGraph(std::string(TEST_DATA_DIR) + "/cerebral-artery-graphs", number + 1);
    std::map<int, Eigen::Vector3d> nodes;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const ArteryGraph::Row& row : graph.nodes) {
        nodes[static_cast<int>(row[0])] = voxelMm * Eigen::Vector3d(row[1], row[2], row[3]);
        mean += nodes[static_cast<int>(row[0])] / static_cast<double>(graph.nodes.size());
    }
    core::VesselTree tree;
    for (const ArteryGraph::Row& row : graph.edges) {
        const Eigen::Vector3d from = nodes[static_cast<int>(row[0])] - mean;
        const Eigen::Vector3d to = nodes[static_cast<int>(row[1])] - mean;
        const double chordMm = (to - from).norm();
        if (chordMm < 2.0) {
            continue;
        }
        core::VesselBranch branch;
        branch.id = static_cast<int>(tree.branches.size());
        branch.pointsInPatient =
            arched(from, to, std::clamp(voxelMm * row[2], 1.02 * chordMm, maxTortuous * chordMm), random);
        branch.radiusMm.assign(branch.pointsInPatient.size(), voxelMm * row[3] / 2.0);
        tree.branches.push_back(std::move(branch));
    }
    return core::resampled(tree, 1.0);
}

core::VesselTree treeToDeform(const std::string& which, std::uint64_t number)
{
    if (which == "grown") {
        core::TreeOptions options;
        options.branchCount = 30 + static_cast<int>(number % 4) * 10;
        options.extentMm = 150.0;
        return core::simulateTree(900 + number, options);
    }
    return graphTree(static_cast<int>(number % graphTreeCount), core::CounterRandom(500 + number));
}

}   // namespace angiopose::benchmarks
