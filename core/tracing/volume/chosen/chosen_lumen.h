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

constexpr double chosenShare = 0.9;   ///< of the stage "vessels", when the lumen is known

/// The lumen that is to be traced, cropped.
struct ChosenLumen {
    VoxelMask lumen;
    VoxelBox box;   ///< where it lies in the whole, patient axis order
    Messages warnings;   ///< about seeds
    std::vector<TracedPiece> leftOut;   ///< pieces, the largest first
    std::vector<Eigen::Vector3d> startsInPatient;   ///< where its vessels were reached from; empty: nowhere special
};

/// What the seeds ask for, or without seeds the first great vessel (all of them, where all pieces are wanted), else all
/// or the largest of the pieces of a mask in patient axis order. `fill` may be empty. Fails for seeds in no vessel and
/// when stopped.
Result<ChosenLumen> chosenLumen(VoxelMask whole, VesselTracingOptions options, const VoxelFill& fill,
                                const std::vector<GreatVessel>& greatVessels, TracingProgress& progress);

/// The same, with places counted from `low`; `fill` must outlive the result.
VoxelFill movedBy(const VoxelFill& fill, const Eigen::Vector3i& low);

}   // namespace angiopose::core