#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/great_vessels/great_vessels.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/chosen_pieces.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose::core {

constexpr double chosenShare = 0.9;   ///< progress share of the stage "vessels" at which the lumen is known

/// The lumen to be traced, cropped.
struct ChosenLumen {
    VoxelMask lumen;
    VoxelBox box;   ///< position in the whole volume, patient axis order
    Messages warnings;   ///< about seeds
    std::vector<TracedPiece> leftOut;   ///< connected components, the largest first
    std::vector<Eigen::Vector3d> startsInPatient;   ///< starting points of its vessels; empty: none in particular
};

/// Selects the lumen to be traced in a mask with patient axis order: the vessels at the seeds, or without seeds the
/// first great vessel (all of them if all components are wanted), or else all components or the largest. `fill` may be
/// empty. Fails for seeds outside any vessel and when stopped.
Result<ChosenLumen> chosenLumen(VoxelMask whole, VesselTracingOptions options, const VoxelFill& fill,
                                const std::vector<GreatVessel>& greatVessels, TracingProgress& progress);

/// Shifts a fill so that voxels are counted from `low`; `fill` must outlive the result.
VoxelFill movedBy(const VoxelFill& fill, const Eigen::Vector3i& low);

}   // namespace angiopose::core