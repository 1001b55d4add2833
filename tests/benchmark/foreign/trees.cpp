#include "tests/benchmark/foreign/trees.h"

#include "tests/benchmark/artery_graph.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

namespace angiopose::benchmarks {
namespace {

constexpr double voxelMm = 0.4;   // typical of time-of-flight MRA; not recorded with the data
constexpr double inflowBelowVoxels = 15.0;   // the neck arteries enter at the lower face
constexpr double inflowRadiusVoxels = 2.5;
constexpr double pointSpacingMm = 0.9;
constexpr double maxBow = 2.0;   // multiple of the chord's length

using Row = ArteryGraph::Row;

double lengthOf(const std::vector<Eigen::Vector3d>& points)
{
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        length += (points[i] - points[i - 1]).norm();
    }
    return length;
}

/// A curve between two points that bows out at random until it has the given length.
class Bow {
public:
    Bow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, ForeignRandom& random) : from_(from), chord_(to - from)
    {
        const Eigen::Vector3d along = chord_.normalized();
        for (Eigen::Vector3d& swing : swings_) {
            swing = along.cross(random.direction());
        }
        swings_[1] *= 0.5;
        swings_[2] *= 0.3;
    }

    std::vector<Eigen::Vector3d> ofLength(double lengthMm) const
    {
        const double wanted = std::min(lengthMm, maxBow * chord_.norm());
        double low = 0.0;
        double high = 2.0 * chord_.norm();
        for (int halving = 0; halving < 30; ++halving) {
            const double middle = 0.5 * (low + high);
            (lengthOf(swung(middle, lengthMm)) < wanted ? low : high) = middle;
        }
        return swung(low, lengthMm);
    }

private:
    std::vector<Eigen::Vector3d> swung(double amplitudeMm, double lengthMm) const
    {
        const int steps = std::max(3, static_cast<int>(lengthMm / pointSpacingMm));
        std::vector<Eigen::Vector3d> points;
        for (int k = 0; k <= steps; ++k) {
            const double share = static_cast<double>(k) / steps;
            Eigen::Vector3d point = from_ + share * chord_;
            for (std::size_t wave = 0; wave < swings_.size(); ++wave) {
                const double phase = share * std::numbers::pi * static_cast<double>(wave + 1);
                point += amplitudeMm * std::sin(phase) * swings_[wave];
            }
            points.push_back(point);
        }
        return points;
    }

    Eigen::Vector3d from_;
    Eigen::Vector3d chord_;
    std::array<Eigen::Vector3d, 3> swings_;
};

/// Index of the node at one end (0 or 1) of an edge.
std::size_t nodeAt(const ArteryGraph& graph, std::size_t edge, std::size_t end)
{
    const auto found =
        std::ranges::find_if(graph.nodes, [&](const Row& node) { return node[0] == graph.edges[edge][end]; });
    return static_cast<std::size_t>(found - graph.nodes.begin());
}

Eigen::Vector3d placeMm(const ArteryGraph& graph, std::size_t node)
{
    return voxelMm * Eigen::Vector3d(graph.nodes[node][1], graph.nodes[node][2], graph.nodes[node][3]);
}

/// Distance of every node from the inflow, along the vessels, and the edge through which it is reached.
struct Flow {
    std::vector<double> distance;
    std::vector<int> through;

    explicit Flow(const ArteryGraph& graph)
        : distance(graph.nodes.size(), std::numeric_limits<double>::infinity()), through(graph.nodes.size(), -1)
    {
        std::vector<int> degree(graph.nodes.size(), 0);
        for (std::size_t edge = 0; edge < graph.edges.size(); ++edge) {
            ++degree[nodeAt(graph, edge, 0)];
            ++degree[nodeAt(graph, edge, 1)];
        }
        for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
            const Row& reported = graph.nodes[node];
            if (degree[node] == 1 && reported[3] < inflowBelowVoxels && reported[4] >= inflowRadiusVoxels) {
                distance[node] = 0.0;
            }
        }
        spread(graph);
        const auto isCutOff = [](double way) { return std::isinf(way); };
        for (auto piece = std::ranges::find_if(distance, isCutOff); piece != distance.end();
             piece = std::ranges::find_if(distance, isCutOff)) {
            *piece = 0.0;   // a separate component
            spread(graph);
        }
    }

private:
    void spread(const ArteryGraph& graph)
    {
        for (bool isChanged = true; isChanged;) {
            isChanged = false;
            for (std::size_t edge = 0; edge < graph.edges.size(); ++edge) {
                for (const std::size_t end : {0U, 1U}) {
                    const std::size_t near = nodeAt(graph, edge, end);
                    const std::size_t far = nodeAt(graph, edge, 1 - end);
                    const double reached = distance[near] + graph.edges[edge][2];
                    if (reached < distance[far]) {
                        distance[far] = reached;
                        through[far] = static_cast<int>(edge);
                        isChanged = true;
                    }
                }
            }
        }
    }
};

RootedTree rooted(const ArteryGraph& graph, ForeignRandom& random)
{
    const Flow flow(graph);
    RootedTree result;
    result.name = graph.name;
    for (std::size_t edge = 0; edge < graph.edges.size(); ++edge) {
        std::size_t near = nodeAt(graph, edge, 0);
        std::size_t far = nodeAt(graph, edge, 1);
        if (flow.distance[far] < flow.distance[near]) {
            std::swap(near, far);
        }
        core::VesselBranch branch;
        branch.id = static_cast<int>(edge) + 1;
        const double lengthMm = voxelMm * graph.edges[edge][2];
        branch.pointsInPatient = Bow(placeMm(graph, near), placeMm(graph, far), random).ofLength(lengthMm);
        branch.radiusMm.assign(branch.pointsInPatient.size(), voxelMm * graph.edges[edge][3]);
        result.tree.branches.push_back(std::move(branch));
        result.parent.push_back(flow.through[near]);
    }
    return result;
}

void fork(RootedTree& tree, int parent, const Eigen::Vector3d& from, const Eigen::Vector3d& direction, int generation,
          ForeignRandom& random)
{
    constexpr int generations = 5;
    const double chordMm = random.uniform(10.0, 30.0) * (generation == 0 ? 1.5 : 1.0);
    const Eigen::Vector3d to = from + chordMm * direction;
    core::VesselBranch branch;
    branch.id = static_cast<int>(tree.tree.branches.size()) + 1;
    branch.pointsInPatient = Bow(from, to, random).ofLength(chordMm * random.uniform(1.05, 1.5));
    branch.radiusMm.assign(branch.pointsInPatient.size(), 2.2 * std::pow(0.8, generation));
    const int own = static_cast<int>(tree.tree.branches.size());
    tree.tree.branches.push_back(std::move(branch));
    tree.parent.push_back(parent);
    if (generation + 1 == generations || (generation > 2 && random.uniform() < 0.2)) {
        return;
    }
    const Eigen::Vector3d side = direction.cross(random.direction()).normalized();
    for (const double way : {-1.0, 1.0}) {
        const double angle = way * random.uniform(0.35, 1.0);
        fork(tree, own, to, Eigen::AngleAxisd(angle, side) * direction, generation + 1, random);
    }
}

}   // namespace

double ForeignRandom::uniform(double low, double high)
{
    return low + (high - low) * std::ldexp(static_cast<double>(bits_() >> 11U), -53);
}

double ForeignRandom::normal()
{
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

Eigen::Vector3d ForeignRandom::direction()
{
    const double x = normal();
    const double y = normal();
    return Eigen::Vector3d(x, y, normal()).normalized();
}

std::vector<std::size_t> RootedTree::fedThrough(std::size_t branch) const
{
    std::vector<std::size_t> fed;
    for (std::size_t other = 0; other < parent.size(); ++other) {
        int at = static_cast<int>(other);
        while (at >= 0 && at != static_cast<int>(branch)) {
            at = parent[static_cast<std::size_t>(at)];
        }
        if (at >= 0) {
            fed.push_back(other);
        }
    }
    return fed;
}

double RootedTree::lengthMm(const std::vector<std::size_t>& branches) const
{
    double length = 0.0;
    for (const std::size_t branch : branches) {
        length += tree.branches[branch].lengthMm();
    }
    return length;
}

bool RootedTree::isLeaf(std::size_t branch) const
{
    return std::find(parent.begin(), parent.end(), static_cast<int>(branch)) == parent.end();
}

std::vector<RootedTree> cerebralTrees(const std::string& folder)
{
    std::vector<RootedTree> trees;
    for (int patient = 1; patient <= arteryGraphCount; ++patient) {
        ArteryGraph graph = readArteryGraph(folder, patient);
        if (graph.edges.empty()) {
            return {};
        }
        std::erase_if(graph.edges, [](const Row& edge) { return edge[0] == edge[1]; });   // loops have no course
        ForeignRandom random(static_cast<std::uint64_t>(patient));
        trees.push_back(rooted(graph, random));
    }
    return trees;
}

std::vector<RootedTree> forkedTrees(std::size_t count)
{
    std::vector<RootedTree> trees;
    for (std::size_t number = 0; number < count; ++number) {
        ForeignRandom random(1000 + number);
        RootedTree tree;
        tree.name = "forked " + std::to_string(number + 1);
        for (const double side : {-12.0, 12.0}) {
            const Eigen::Vector3d up = (Eigen::Vector3d(side / 30.0, 0.0, 1.0) + 0.2 * random.direction()).normalized();
            fork(tree, -1, Eigen::Vector3d(side, 0.0, 0.0), up, 0, random);
        }
        trees.push_back(std::move(tree));
    }
    return trees;
}

std::vector<RootedTree> treesOfFamily(const std::string& family)
{
    const std::vector<RootedTree> trees =
        family == "real" ? cerebralTrees(std::string(TEST_DATA_DIR) + "/cerebral-artery-graphs") : forkedTrees(10);
    if (trees.empty()) {
        std::fprintf(stderr, "The graphs of cerebral arteries are not there.\n");
    }
    return trees;
}

}   // namespace angiopose::benchmarks
