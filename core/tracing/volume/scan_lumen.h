#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/great_vessels/find_great_vessels.h"
#include "core/tracing/volume/great_vessels/skull.h"
#include "core/tracing/volume/lumen/bias_field.h"
#include "core/tracing/volume/lumen/lumen_levels.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/vessel/vessel_tree.h"

#include <optional>
#include <vector>

namespace angiopose::core {

/// Lumen candidates of a scan, and the data from which they were derived.
struct ScanLumen {
    std::optional<BiasCorrectedScan> corrected;   ///< set if the intensity inhomogeneity was corrected
    LumenLevels level;
    LumenWithGreatVessels found;   ///< only great vessels suitable as a starting point
    std::optional<Skull> skull;   ///< set for head CT
    std::vector<Eigen::Vector3d> veins;   ///< centerline points of the dural venous sinuses

    /// Returns the scan that was evaluated; `given` is the original scan.
    const Volume& scan(const Volume& given) const { return corrected ? corrected->volume : given; }
};

/// Returns the opacification of a voxel: 0 in soft tissue, 1 in the lumen. The arguments must outlive the result.
VoxelOpacification voxelOpacification(const Volume& volume, const AxisOrder& order, const LumenLevels& level);

/// Finds the lumen candidates. Fails if nothing has the intensity of an opacified lumen. Fails with a request for a
/// seed if no seed is placed and the arteries cannot be identified: in head CT with opacified venous sinuses, and
/// without Hounsfield units if no vessel is definitely an artery. Reports the stages "blood" and "vessels".
Result<ScanLumen> findScanLumen(const Volume& volume, const AxisOrder& order, const VesselTracingOptions& options,
                                TracingProgress& progress);

/// Returns whether a tree traced without a seed runs along the skull, like venous sinuses and unlike arteries.
bool runsAlongSkull(const VesselTree& tree, const Skull& skull);

}   // namespace angiopose::core
