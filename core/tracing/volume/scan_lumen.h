#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/great_vessels/find_great_vessels.h"
#include "core/tracing/volume/great_vessels/skull.h"
#include "core/tracing/volume/lumen/blood_level.h"
#include "core/tracing/volume/lumen/coil_field.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/vessel/vessel_tree.h"

#include <optional>
#include <vector>

namespace angiopose::core {

/// What of a scan can be lumen, and how that was told.
struct ScanLumen {
    std::optional<BiasCorrectedScan> corrected;   ///< where a coil's fall-off was taken out
    BloodLevel level;
    LumenWithGreatVessels found;   ///< of the great vessels those that may be begun at
    std::optional<Skull> skull;   ///< of a head by CT
    std::vector<Eigen::Vector3d> veins;   ///< on the axes of sinuses

    /// The scan that was looked at; `given` is the one it came from.
    const Volume& scan(const Volume& given) const { return corrected ? corrected->volume : given; }
};

/// How much of each voxel is blood, by its value between soft tissue and blood. The three must outlive it.
VoxelFill bloodShare(const Volume& volume, const AxisOrder& order, const BloodLevel& level);

/// Fails where nothing is like blood, and asks for a seed where none is placed and it is not clear what is an artery:
/// in heads by CT whose sinuses are filled, and without Hounsfield units where nothing is an artery for sure. Reports
/// the stages "blood" and "vessels".
Result<ScanLumen> findScanLumen(const Volume& volume, const AxisOrder& order, const VesselTracingOptions& options,
                                TracingProgress& progress);

/// Whether what was traced without a seed runs along the skull, as sinuses do and arteries do not.
bool runsAlongSkull(const VesselTree& tree, const Skull& skull);

}   // namespace angiopose::core
