#pragma once

#include "core/tracing/volume/voxels/distance_map.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

// Between skeleton and tree all points are in mm along the axes of the voxel grid, from the centre of its first voxel.

namespace angiopose::core {

/// A stretch of skeleton between two nodes; its points begin and end at them.
struct VesselEdge {
    int startNode = 0;
    int endNode = 0;
    std::vector<Eigen::Vector3d> pointsMm;
    std::vector<double> radiusMm;   ///< of the largest ball in the lumen, one per point

    double lengthMm() const;
};

/// Junctions and free ends of a skeleton, and what runs between them. A closed ring is an edge from a node to itself.
struct VesselGraph {
    std::vector<Eigen::Vector3d> nodesMm;
    std::vector<double> nodeRadiusMm;
    std::vector<VesselEdge> edges;

    std::vector<int> degrees() const;
    std::vector<std::vector<std::size_t>> edgesByNode() const;   ///< a ring twice at its node
    VesselEdge leaving(std::size_t edge, int node) const;   ///< the edge as it runs from one of its nodes
};

/// Graph of a one voxel thin skeleton, given as ascending voxel indices; touching junction voxels are one node at their
/// centroid. Empty when stopped.
VesselGraph vesselGraph(const std::vector<std::size_t>& skeleton, const DistanceMap& distances,
                        TracingProgress& progress);

/// The edge seen from its other end.
VesselEdge reversed(VesselEdge edge);

}   // namespace angiopose::core