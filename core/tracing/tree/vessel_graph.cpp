#include "core/tracing/tree/vessel_graph.h"

#include "core/vessel/polyline.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr std::size_t minRingPoints = 6;
constexpr std::size_t graphProgressMask = 0xFFF;   ///< bit mask; progress is reported every 4096 voxels

/// Follows the skeleton voxel by voxel. Voxels are identified by their index in the list of skeleton voxels.
class VoxelGraphBuilder {
public:
    VoxelGraphBuilder(const std::vector<std::size_t>& skeleton, const DistanceMap& distances)
        : skeleton_(skeleton), distances_(distances), nodeAt_(skeleton.size(), -1), visited_(skeleton.size(), false)
    {
    }

    /// Finds the neighbors of all voxels; returns false when stopped.
    bool findAllNeighbors(TracingProgress& progress)
    {
        neighbors_.reserve(skeleton_.size());
        for (std::size_t v = 0; v < skeleton_.size(); ++v) {
            if ((v & graphProgressMask) == 0 && !progress.advance(0.0)) {
                return false;
            }
            neighbors_.push_back(findNeighbors(v));
        }
        return true;
    }

    VesselGraph run()
    {
        addJunctions();
        addEnds();
        for (std::size_t v = 0; v < skeleton_.size(); ++v) {
            if (nodeAt_[v] >= 0) {
                addEdgesFrom(v);
            }
        }
        addRings();
        return std::move(graph_);
    }

private:
    Eigen::Vector3i voxelOf(std::size_t v) const { return distances_.geometry.voxelAt(skeleton_[v]); }

    Eigen::Vector3d pointOf(std::size_t v) const
    {
        return distances_.geometry.spacingMm.cwiseProduct(voxelOf(v).cast<double>());
    }

    /// Returns the lumen radius at a voxel. The wall lies half a voxel before the center of the first outside voxel.
    double radiusOf(std::size_t v) const
    {
        const double half = 0.5 * distances_.geometry.spacingMm.minCoeff();
        return std::max(half, distances_.mm(skeleton_[v]) - half);
    }

    std::vector<std::size_t> findNeighbors(std::size_t v) const
    {
        const Eigen::Vector3i voxel = voxelOf(v);
        std::vector<std::size_t> neighborIndices;
        for (int z = -1; z <= 1; ++z) {
            for (int y = -1; y <= 1; ++y) {
                for (int x = -1; x <= 1; ++x) {
                    const Eigen::Vector3i next = voxel + Eigen::Vector3i(x, y, z);
                    if (next == voxel || !distances_.geometry.contains(next)) {
                        continue;
                    }
                    const std::size_t index = distances_.geometry.index(next.x(), next.y(), next.z());
                    const auto at = std::lower_bound(skeleton_.begin(), skeleton_.end(), index);
                    if (at != skeleton_.end() && *at == index) {
                        neighborIndices.push_back(static_cast<std::size_t>(at - skeleton_.begin()));
                    }
                }
            }
        }
        return neighborIndices;
    }

    int addNode(const std::vector<std::size_t>& voxels)
    {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double radius = 0.0;
        const int node = static_cast<int>(graph_.nodesMm.size());
        for (const std::size_t v : voxels) {
            sum += pointOf(v);
            radius = std::max(radius, radiusOf(v));
            nodeAt_[v] = node;
            visited_[v] = true;
        }
        graph_.nodesMm.emplace_back(sum / static_cast<double>(voxels.size()));
        graph_.nodeRadiusMm.push_back(radius);
        return node;
    }

    void addJunctions()
    {
        for (std::size_t v = 0; v < skeleton_.size(); ++v) {
            if (nodeAt_[v] >= 0 || neighbors_[v].size() < 3) {
                continue;
            }
            std::vector<std::size_t> cluster{v};
            visited_[v] = true;
            for (std::size_t n = 0; n < cluster.size(); ++n) {
                for (const std::size_t next : neighbors_[cluster[n]]) {
                    if (!visited_[next] && neighbors_[next].size() > 2) {
                        visited_[next] = true;
                        cluster.push_back(next);
                    }
                }
            }
            addNode(cluster);
        }
    }

    void addEnds()
    {
        for (std::size_t v = 0; v < skeleton_.size(); ++v) {
            if (nodeAt_[v] < 0 && neighbors_[v].size() == 1) {
                addNode({v});
            }
        }
    }

    void addEdgesFrom(std::size_t nodeVoxel)
    {
        for (const std::size_t first : neighbors_[nodeVoxel]) {
            const int start = nodeAt_[nodeVoxel];
            const int neighborNode = nodeAt_[first];
            if (neighborNode > start) {   // adjacent nodes; the edge is added once
                graph_.edges.push_back({start,
                                        neighborNode,
                                        {nodePoint(start), nodePoint(neighborNode)},
                                        {nodeRadius(start), nodeRadius(neighborNode)}});
            } else if (neighborNode < 0 && !visited_[first]) {
                addEdge(nodeVoxel, first);
            }
        }
    }

    /// Follows the skeleton from a node over `first` to the next node. A voxel in between has exactly two neighbors, so
    /// the path is unambiguous.
    void addEdge(std::size_t nodeVoxel, std::size_t first)
    {
        const int start = nodeAt_[nodeVoxel];
        VesselEdge edge{start, start, {nodePoint(start)}, {nodeRadius(start)}};
        std::size_t previous = nodeVoxel;
        std::size_t current = first;
        while (nodeAt_[current] < 0) {
            edge.pointsMm.push_back(pointOf(current));
            edge.radiusMm.push_back(radiusOf(current));
            visited_[current] = true;
            const std::vector<std::size_t>& adjacent = neighbors_[current];
            const std::size_t next = adjacent[0] == previous ? adjacent[1] : adjacent[0];
            previous = current;
            current = next;
        }
        edge.endNode = nodeAt_[current];
        edge.pointsMm.push_back(nodePoint(edge.endNode));
        edge.radiusMm.push_back(nodeRadius(edge.endNode));
        const bool isTinyLoop = edge.startNode == edge.endNode && edge.pointsMm.size() < minRingPoints;
        if (!isTinyLoop) {
            graph_.edges.push_back(std::move(edge));
        }
    }

    void addRings()
    {
        for (std::size_t v = 0; v < skeleton_.size(); ++v) {
            if (!visited_[v] && neighbors_[v].size() == 2) {
                addNode({v});
                addEdge(v, neighbors_[v][0]);
            }
        }
    }

    const Eigen::Vector3d& nodePoint(int node) const { return graph_.nodesMm[static_cast<std::size_t>(node)]; }
    double nodeRadius(int node) const { return graph_.nodeRadiusMm[static_cast<std::size_t>(node)]; }

    const std::vector<std::size_t>& skeleton_;
    const DistanceMap& distances_;
    std::vector<std::vector<std::size_t>> neighbors_;
    std::vector<int> nodeAt_;   ///< node of junction and end voxels, -1 elsewhere
    std::vector<bool> visited_;
    VesselGraph graph_;
};

}   // namespace

double VesselEdge::lengthMm() const
{
    return polylineLength<3>(pointsMm);
}

std::vector<int> VesselGraph::degrees() const
{
    std::vector<int> result(nodesMm.size(), 0);
    for (const VesselEdge& edge : edges) {
        ++result[static_cast<std::size_t>(edge.startNode)];
        ++result[static_cast<std::size_t>(edge.endNode)];
    }
    return result;
}

std::vector<std::vector<std::size_t>> VesselGraph::edgesByNode() const
{
    std::vector<std::vector<std::size_t>> edgesOfNodes(nodesMm.size());
    for (std::size_t e = 0; e < edges.size(); ++e) {
        edgesOfNodes[static_cast<std::size_t>(edges[e].startNode)].push_back(e);
        edgesOfNodes[static_cast<std::size_t>(edges[e].endNode)].push_back(e);
    }
    return edgesOfNodes;
}

VesselEdge VesselGraph::leaving(std::size_t edge, int node) const
{
    return edges[edge].startNode == node ? edges[edge] : reversed(edges[edge]);
}

VesselGraph buildVesselGraph(const std::vector<std::size_t>& skeleton, const DistanceMap& distances,
                             TracingProgress& progress)
{
    VoxelGraphBuilder walker(skeleton, distances);
    return walker.findAllNeighbors(progress) ? walker.run() : VesselGraph();
}

VesselEdge reversed(VesselEdge edge)
{
    std::swap(edge.startNode, edge.endNode);
    std::reverse(edge.pointsMm.begin(), edge.pointsMm.end());
    std::reverse(edge.radiusMm.begin(), edge.radiusMm.end());
    return edge;
}

}   // namespace angiopose::core
