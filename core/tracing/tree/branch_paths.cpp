#include "core/tracing/tree/branch_paths.h"

#include "core/tracing/tree/edge_takeoff.h"
#include "core/tracing/tree/root_end.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <numeric>

namespace angiopose::core {
namespace {

constexpr double directionWeight = 0.8;
constexpr double maxSeedToWallMm = 5.0;   ///< maximum distance from a seed to the wall of its vessel

/// A path that starts at `node` along `edge`.
struct Start {
    std::size_t edge = 0;
    int node = 0;
    int parent = -1;
    int generation = 0;
};

class PathBuilder {
public:
    explicit PathBuilder(const VesselGraph& graph)
        : graph_(graph),
          edgesByNode_(graph.edgesByNode()),
          used_(graph.edges.size(), false),
          owner_(graph.nodesMm.size(), -1)
    {
    }

    std::vector<BranchPath> run(const std::optional<Eigen::Vector3d>& rootMm,
                                const std::vector<Eigen::Vector3d>& seedsMm, PathComponents withoutSeeds)
    {
        for (const std::vector<int>& nodes : components()) {
            const bool isSelected =
                !seedsMm.empty() ? isNearSeed(nodes, seedsMm) : paths_.empty() || withoutSeeds == PathComponents::All;
            const int root = isSelected ? rootOf(nodes, rootMm) : -1;
            if (root >= 0) {
                const std::vector<std::size_t>& edges = edgesByNode_[static_cast<std::size_t>(root)];
                starts_.push_back({edges.front(), root, -1, 0});
                for (const std::size_t e : edges) {   // a ring may have several edges at its root
                    starts_.push_back({e, root, static_cast<int>(paths_.size()), 1});
                }
                followAll();
            }
        }
        return std::move(paths_);
    }

private:
    double nodeRadius(int node) const { return graph_.nodeRadiusMm[static_cast<std::size_t>(node)]; }

    /// Returns the root node of a component: a free end, or the widest node if there is no free end.
    int rootOf(const std::vector<int>& nodes, const std::optional<Eigen::Vector3d>& rootMm) const
    {
        const int end = findRootEnd(graph_, edgesByNode_, nodes, rootMm);
        return end >= 0 ? end : *std::ranges::max_element(nodes, {}, [this](int node) { return nodeRadius(node); });
    }

    /// Returns the nodes of each connected component, greatest vessel length first.
    std::vector<std::vector<int>> components() const
    {
        std::vector<std::vector<int>> unsorted;
        std::vector<double> lengths;
        std::vector<bool> visited(graph_.nodesMm.size(), false);
        for (int node = 0; node < static_cast<int>(visited.size()); ++node) {
            if (visited[static_cast<std::size_t>(node)] || edgesByNode_[static_cast<std::size_t>(node)].empty()) {
                continue;
            }
            visited[static_cast<std::size_t>(node)] = true;
            std::vector<int> component{node};
            double length = 0.0;
            for (std::size_t n = 0; n < component.size(); ++n) {
                for (const std::size_t e : edgesByNode_[static_cast<std::size_t>(component[n])]) {
                    const VesselEdge& edge = graph_.edges[e];
                    length += 0.5 * edge.lengthMm();
                    const int other = edge.startNode == component[n] ? edge.endNode : edge.startNode;
                    if (!visited[static_cast<std::size_t>(other)]) {
                        visited[static_cast<std::size_t>(other)] = true;
                        component.push_back(other);
                    }
                }
            }
            unsorted.push_back(std::move(component));
            lengths.push_back(length);
        }
        std::vector<std::size_t> order(unsorted.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
        std::vector<std::vector<int>> sorted;
        sorted.reserve(order.size());
        for (const std::size_t p : order) {
            sorted.push_back(std::move(unsorted[p]));
        }
        return sorted;
    }

    bool isNearSeed(const std::vector<int>& nodes, const std::vector<Eigen::Vector3d>& seedsMm) const
    {
        for (const int node : nodes) {
            for (const std::size_t e : edgesByNode_[static_cast<std::size_t>(node)]) {
                const VesselEdge& edge = graph_.edges[e];
                for (std::size_t i = 0; i < edge.pointsMm.size(); ++i) {
                    const double reach = maxSeedToWallMm + 1.5 * edge.radiusMm[i];
                    if (std::any_of(seedsMm.begin(), seedsMm.end(),
                                    [&](const auto& seed) { return (seed - edge.pointsMm[i]).norm() <= reach; })) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    void followAll()
    {
        while (!starts_.empty()) {
            const Start start = starts_.front();
            starts_.pop_front();
            if (!used_[start.edge]) {
                follow(start);
            }
        }
    }

    void follow(const Start& start)
    {
        const int index = static_cast<int>(paths_.size());
        BranchPath path{start.parent, start.generation, -1, {}, {}};
        std::size_t edge = start.edge;
        int node = start.node;
        claimNode(node, index);
        for (bool shouldContinue = true; shouldContinue;) {
            const VesselEdge directedEdge = graph_.leaving(edge, node);
            used_[edge] = true;
            const std::ptrdiff_t skip = path.pointsMm.empty() ? 0 : 1;   // the node is already in the path
            path.pointsMm.insert(path.pointsMm.end(), directedEdge.pointsMm.begin() + skip,
                                 directedEdge.pointsMm.end());
            path.radiusMm.insert(path.radiusMm.end(), directedEdge.radiusMm.begin() + skip,
                                 directedEdge.radiusMm.end());
            node = directedEdge.endNode;
            shouldContinue = false;
            path.loopTarget = claimNode(node, index);
            if (path.loopTarget >= 0) {
                break;   // the other edges at this node are branches of the vessel that was reached
            }
            const std::size_t next = continuation(directedEdge);
            for (const std::size_t e : edgesByNode_[static_cast<std::size_t>(node)]) {
                if (e == next) {
                    shouldContinue = true;
                } else if (!used_[e]) {
                    starts_.push_back({e, node, index, start.generation + 1});
                }
            }
            edge = next;
        }
        paths_.push_back(std::move(path));
    }

    /// Returns the previous owner of a node (-1 if none) and assigns an unowned node to `path`.
    int claimNode(int node, int path)
    {
        int& owner = owner_[static_cast<std::size_t>(node)];
        const int before = owner;
        owner = before < 0 ? path : before;
        return before;
    }

    /// Returns the edge that continues the vessel after `directedEdge`, or the number of edges if the vessel ends.
    std::size_t continuation(const VesselEdge& directedEdge) const
    {
        const EdgeTakeoff arriving = measureTakeoff(reversed(directedEdge), nodeRadius(directedEdge.endNode));
        std::size_t best = graph_.edges.size();
        double bestScore = -std::numeric_limits<double>::infinity();
        for (const std::size_t e : edgesByNode_[static_cast<std::size_t>(directedEdge.endNode)]) {
            if (used_[e]) {
                continue;
            }
            const EdgeTakeoff takeoff =
                measureTakeoff(graph_.leaving(e, directedEdge.endNode), nodeRadius(directedEdge.endNode));
            const double score = std::min(1.0, takeoff.radiusMm / arriving.radiusMm) -
                                 directionWeight * takeoff.direction.dot(arriving.direction);
            if (score > bestScore + 1e-9) {
                bestScore = score;
                best = e;
            }
        }
        return best;
    }

    const VesselGraph& graph_;
    std::vector<std::vector<std::size_t>> edgesByNode_;   ///< edge indices by node
    std::vector<bool> used_;
    std::vector<int> owner_;   ///< first path through each node
    std::deque<Start> starts_;
    std::vector<BranchPath> paths_;
};

}   // namespace

std::vector<BranchPath> splitIntoPaths(const VesselGraph& graph, const std::optional<Eigen::Vector3d>& rootMm,
                                       const std::vector<Eigen::Vector3d>& seedsMm, PathComponents withoutSeeds)
{
    return PathBuilder(graph).run(rootMm, seedsMm, withoutSeeds);
}

}   // namespace angiopose::core
