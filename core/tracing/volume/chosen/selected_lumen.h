#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/great_vessels/great_vessels.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/component_selection.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose::core {

constexpr double selectedProgress = 0.9;   ///< progress within the stage "vessels" at which the lumen is known

/// The lumen to be traced, cropped.
struct SelectedLumen {
    VoxelMask lumen;
    VoxelBox box;   ///< position in the whole volume, patient axis order
    Messages warnings;   ///< warnings about seeds
    std::vector<TracedComponent> excluded;   ///< excluded connected components, largest first
    std::vector<Eigen::Vector3d> startPointsInPatient;   ///< start points in the vessels; empty to start anywhere
};

/// Selects the lumen to trace from a mask in patient axis order: the vessels at the seeds; without seeds, the first
/// great vessel (all great vessels if all components are requested); without great vessels, all components or the
/// largest. `opacification` may be empty. Fails for seeds outside any vessel and when stopped.
Result<SelectedLumen> selectLumen(VoxelMask whole, VesselTracingOptions options,
                                  const VoxelOpacification& opacification, const std::vector<GreatVessel>& greatVessels,
                                  TracingProgress& progress);

/// Shifts the voxel indices of `opacification` so that they count from `low`; `opacification` must outlive the result.
VoxelOpacification shiftOrigin(const VoxelOpacification& opacification, const Eigen::Vector3i& low);

}   // namespace angiopose::core
