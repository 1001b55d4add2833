#pragma once

#include "core/imaging/volume.h"
#include "core/support/message.h"
#include "core/tracing/volume/voxels/traced_piece.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// A vessel tree with what was seen on the way to it.
struct TracedVessels {
    VesselTree tree;   ///< piece by piece, in each root first, then by generation; ids 1, 2, …; radii, patient LPS
    VoxelMask lumen;   ///< the voxels that were traced, in the geometry of the input
    double threshold = 0.0;   ///< the value at which the lumen begins; 0.5 for masks
    std::optional<Eigen::Vector3d>
        foundStart;   ///< without seeds: a place in the great vessel that was begun at, LPS mm
    std::vector<TracedPiece> pieces;   ///< of what could be traced, the largest first
    Messages warnings;   ///< pieces that were left out, loops that were opened, …
};

}   // namespace angiopose::core
