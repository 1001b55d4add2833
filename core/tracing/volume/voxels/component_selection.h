#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/voxels/traced_component.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/tracing/volume/voxels/voxel_components.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Formats a point as "(x, y, z)" in mm for a message.
Message formatPoint(const Eigen::Vector3d& point);

/// Returns the nearest set voxel within 3 mm of a point in the patient (LPS, mm); nullopt if there is none.
std::optional<std::uint32_t> findVoxelNear(const VoxelMask& mask, const Eigen::Vector3d& seedInPatient);

/// Seeds, moved into the intended lumen where necessary.
struct SeedsInLumen {
    std::vector<Eigen::Vector3d> seedPoints;
    Messages warnings;   ///< warnings about seeds that were moved far
};

/// Keeps seeds up to 3 mm beside the lumen in place, and moves others to the center of a wide vessel (voxels above 1)
/// within 10 mm, because unopacified parts such as thrombus and calcified plaque belong to the vessel too. Fails,
/// naming the seed, if no lumen is close enough.
Result<SeedsInLumen> moveSeedsIntoLumen(const VoxelMask& mask, const std::vector<Eigen::Vector3d>& seedsInPatient);

/// Restricts a mask to the requested connected components: those that contain the seeds (LPS, mm; within 3 mm), or
/// without seeds all components or the largest, i.e. the one with the most voxels above 1 (cores of vessels), in a tie
/// the one with the most voxels. Returns the excluded components, largest first. Fails for a seed outside all
/// components (naming the seed), for an empty mask, and when stopped.
Result<std::vector<TracedComponent>> selectComponents(VoxelMask& mask,
                                                      const std::vector<Eigen::Vector3d>& seedsInPatient,
                                                      TracedPieces withoutSeeds, TracingProgress& progress);

/// Returns the size of a component and the position of its voxel nearest to the center.
TracedComponent describeComponent(const VoxelComponent& voxels, const VolumeGeometry& grid);

Cancellation tracingCanceled();

}   // namespace angiopose::core
