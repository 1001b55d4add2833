#pragma once

#include "core/tracing/tree/vessel_graph.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace angiopose::core {

/// The free end among `nodes` that is nearest to `rootMm`, or else that of the thickest vessel: at the root of the
/// aorta the coronary arteries count as its ends, while stumps on its wall are ignored. -1 if there is no free end.
/// `meeting` holds the graph's edges by node.
int rootEnd(const VesselGraph& graph, const std::vector<std::vector<std::size_t>>& meeting,
            const std::vector<int>& nodes, const std::optional<Eigen::Vector3d>& rootMm);

}   // namespace angiopose::core