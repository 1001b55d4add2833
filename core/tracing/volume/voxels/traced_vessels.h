#pragma once

#include "core/imaging/volume.h"
#include "core/support/message.h"
#include "core/tracing/volume/voxels/traced_component.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// A traced vessel tree with its lumen, components and warnings.
struct TracedVessels {
    VesselTree tree;   ///< patient LPS, with radii; by component, root first, then by generation; ids 1, 2, …
    VoxelMask lumen;   ///< traced voxels, in the geometry of the input
    double threshold = 0.0;   ///< lower limit of the lumen; 0.5 for masks
    std::optional<Eigen::Vector3d>
        foundStart;   ///< without seeds, the point in the great vessel where tracing started, LPS mm
    std::vector<TracedComponent> pieces;   ///< all components that could be traced, the largest first
    Messages warnings;   ///< warnings about components left out, opened loops, …
};

}   // namespace angiopose::core
