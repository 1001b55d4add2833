#pragma once

#include "core/tracing/tree/vessel_graph.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Of the free ends among `nodes` that nearest to `rootMm`, else that of the thickest vessel: at the root of the aorta
/// the coronary arteries are its ends, on its wall stumps are ends that mean nothing. -1 where no end is free.
/// `meeting` holds the graph's edges by node.
int rootEnd(const VesselGraph& graph, const std::vector<std::vector<std::size_t>>& meeting,
            const std::vector<int>& nodes, const std::optional<Eigen::Vector3d>& rootMm);

}   // namespace angiopose::core