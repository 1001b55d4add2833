#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/voxels/traced_piece.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace angiopose::core {

/// "(x, y, z)" in mm, for a message.
Message placeInMessage(const Eigen::Vector3d& point);

/// The set voxel that is nearest to a place in the patient (LPS mm), if there is one within 3 mm.
std::optional<std::uint32_t> voxelNear(const VoxelMask& mask, const Eigen::Vector3d& seedInPatient);

/// Seeds moved to the lumen that they were meant for.
struct SeedsInLumen {
    std::vector<Eigen::Vector3d> inPatient;
    Messages warnings;   ///< about seeds that were moved far
};

/// Seeds up to 3 mm beside the lumen stay where they are; others are moved to the middle of a wide vessel (voxels above
/// 1) within 10 mm: what does not fill, as thrombus and chalk, is part of the vessel too. Fails, naming it, for a seed
/// that has neither.
Result<SeedsInLumen> seedsInLumen(const VoxelMask& mask, const std::vector<Eigen::Vector3d>& seedsInPatient);

/// Leaves of a mask what is asked for: the pieces that hold the seeds (LPS mm, within 3 mm), or without seeds all or
/// the largest: that with the most voxels above 1 (cores of vessels), of equal ones that with the most voxels. Returns
/// the others, the largest first. Fails, naming it, for a seed that lies in no piece, for an empty mask, and when
/// stopped.
Result<std::vector<TracedPiece>> keepChosenPieces(VoxelMask& mask, const std::vector<Eigen::Vector3d>& seedsInPatient,
                                                  TracedPieces withoutSeeds, TracingProgress& progress);

/// Its size, and the place in it that is nearest to its middle.
TracedPiece pieceOf(const VoxelPiece& voxels, const VolumeGeometry& grid);

Stopped stoppedTracing();

}   // namespace angiopose::core