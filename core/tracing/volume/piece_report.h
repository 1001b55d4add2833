#pragma once

#include "core/imaging/volume.h"
#include "core/support/message.h"
#include "core/tracing/volume/voxels/traced_piece.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::core {

/// Lists all traceable connected components, largest first: those of the traced lumen with the length of their
/// branches, and those excluded before. Incomplete when stopped.
std::vector<TracedPiece> reportedPieces(const VoxelMask& lumen, const VesselTree& tree,
                                        std::vector<TracedPiece> leftOut, TracingProgress& progress);

/// Returns messages about connected components: which were traced, if there are several and no seed selected them;
/// which were not, if these are more than one in fifty voxels.
Messages pieceWarnings(const std::vector<TracedPiece>& pieces, bool isBySeeds);

}   // namespace angiopose::core
