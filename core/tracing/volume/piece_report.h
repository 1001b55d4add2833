#pragma once

#include "core/imaging/volume.h"
#include "core/support/message.h"
#include "core/tracing/volume/voxels/traced_piece.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::core {

/// Every piece of what could be traced, the largest first: those of the traced lumen with the length of the branches in
/// them, and those that were left out before. Incomplete when stopped.
std::vector<TracedPiece> reportedPieces(const VoxelMask& lumen, const VesselTree& tree,
                                        std::vector<TracedPiece> leftOut, TracingProgress& progress);

/// What is said of pieces: which were traced, where that is several and was not asked for by seeds; which were not,
/// where these are more than one in fifty voxels.
Messages pieceWarnings(const std::vector<TracedPiece>& pieces, bool isBySeeds);

}   // namespace angiopose::core
