#pragma once

#include "core/tracing/tree/vessel_graph.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Returns the free end among `nodes` that is nearest to `rootMm`, or without `rootMm` the end of the thickest vessel:
/// coronary arteries at the aortic root count as ends of the aorta, and stumps on its wall are ignored; -1 if there is
/// no free end. `edgesByNode` holds the edges at each node.
int findRootEnd(const VesselGraph& graph, const std::vector<std::vector<std::size_t>>& edgesByNode,
                const std::vector<int>& nodes, const std::optional<Eigen::Vector3d>& rootMm);

}   // namespace angiopose::core
