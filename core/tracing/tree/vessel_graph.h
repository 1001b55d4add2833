#pragma once

#include "core/tracing/volume/voxels/distance_map.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

// Coordinates from skeleton to tree: all points are in mm along the axes of the voxel grid, measured from the center of
// its first voxel.

namespace angiopose::core {

/// Section of a skeleton between two nodes; its points begin and end at the nodes.
struct VesselEdge {
    int startNode = 0;
    int endNode = 0;
    std::vector<Eigen::Vector3d> pointsMm;
    std::vector<double> radiusMm;   ///< radius of the inscribed sphere at each point

    double lengthMm() const;
};

/// Junctions and free ends of a skeleton, and the edges between them. A closed ring is an edge from a node to itself.
struct VesselGraph {
    std::vector<Eigen::Vector3d> nodesMm;
    std::vector<double> nodeRadiusMm;
    std::vector<VesselEdge> edges;

    std::vector<int> degrees() const;
    std::vector<std::vector<std::size_t>> edgesByNode() const;   ///< a ring appears twice at its node
    VesselEdge leaving(std::size_t edge, int node) const;   ///< the edge oriented to start at `node`
};

/// Builds the graph of a one-voxel-thin skeleton, given as ascending voxel indices; adjacent junction voxels form one
/// node at their centroid. Empty when stopped.
VesselGraph buildVesselGraph(const std::vector<std::size_t>& skeleton, const DistanceMap& distances,
                             TracingProgress& progress);

/// Returns the edge in the opposite direction.
VesselEdge reversed(VesselEdge edge);

}   // namespace angiopose::core
