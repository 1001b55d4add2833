#include "core/tracing/volume/trace_vessels.h"

#include "core/tracing/tree/lumen_tree.h"
#include "core/tracing/volume/axis_order.h"
#include "core/tracing/volume/chosen_pieces.h"
#include "core/tracing/volume/fill_cavities.h"
#include "core/tracing/volume/tracing_progress.h"
#include "core/tracing/volume/voxel_pieces.h"

#include <algorithm>
#include <limits>
#include <set>

namespace core {
namespace {

Error stopped()
{
    return Error{"Tracing was stopped; nothing was kept."};
}

/// The set voxels in patient axis order.
template <class Grid, class IsSet>
VoxelMask maskOf(const Grid& grid, const IsSet& isSet)
{
    const AxisOrder order = patientAxisOrder(grid.geometry);
    VoxelMask whole(order.geometry);
    std::size_t voxel = 0;
    for (int k = 0; k < order.geometry.size.z(); ++k) {
        for (int j = 0; j < order.geometry.size.y(); ++j) {
            for (int i = 0; i < order.geometry.size.x(); ++i, ++voxel) {
                whole.voxels[voxel] = isSet(grid.voxels[order.stored(i, j, k)]) ? 1 : 0;
            }
        }
    }
    return whole;
}

VoxelMask croppedMask(const VoxelMask& mask, const VoxelBox& box)
{
    VoxelMask part(cropped(mask.geometry, box));
    for (int k = 0; k < part.geometry.size.z(); ++k) {
        for (int j = 0; j < part.geometry.size.y(); ++j) {
            const auto row = mask.voxels.begin() + static_cast<std::ptrdiff_t>(mask.geometry.index(
                                                       box.low.x(), j + box.low.y(), k + box.low.z()));
            std::copy_n(row, part.geometry.size.x(),
                        part.voxels.begin() + static_cast<std::ptrdiff_t>(part.geometry.index(0, j, k)));
        }
    }
    return part;
}

/// Back to the order in which the input is stored.
VoxelMask asStored(const VoxelMask& part, const VoxelBox& box, const VolumeGeometry& stored)
{
    VoxelMask whole(stored);
    const AxisOrder order = cropped(patientAxisOrder(stored), box);
    std::size_t voxel = 0;
    for (int k = 0; k < part.geometry.size.z(); ++k) {
        for (int j = 0; j < part.geometry.size.y(); ++j) {
            for (int i = 0; i < part.geometry.size.x(); ++i, ++voxel) {
                whole.voxels[order.stored(i, j, k)] = part.voxels[voxel];
            }
        }
    }
    return whole;
}

std::string problemWith(const VolumeGeometry& geometry, std::size_t voxels)
{
    if (voxels == 0 || geometry.voxelCount() != voxels) {
        return "The volume is empty. Choose another series or file.";
    }
    if (voxels > std::numeric_limits<std::uint32_t>::max()) {
        return "The volume has more than 4 billion voxels. Crop or resample it first.";
    }
    if (!(geometry.spacingMm.minCoeff() > 0.0) || !geometry.spacingMm.allFinite()) {
        return "The volume has no valid voxel spacing. Give the spacing in mm, or export the volume again.";
    }
    return {};
}

std::string loopWarning(int loops)
{
    return std::to_string(loops) + (loops == 1 ? " loop was" : " loops were") +
           " opened at the thinnest place: look there for vessels that only touch.";
}

/// From the lumen in patient axis order to the tree.
Result<TracedVessels> traceLumen(VoxelMask whole, const VolumeGeometry& stored, const VesselTracingOptions& options,
                                 TracingProgress& progress)
{
    TracedVessels traced;
    traced.threshold = 0.5;
    const auto leftOut = keepChosenPieces(whole, options.seedsInPatient);
    if (!leftOut) {
        return leftOut.error();
    }
    const VoxelBox box = grown(boxOf(whole), 1, whole.geometry);
    VoxelMask lumen = croppedMask(whole, box);
    whole = {};
    fillCavities(lumen);
    LumenTree found = lumenTree(lumen, fillOf(lumen), options, progress);
    if (progress.isStopped()) {
        return stopped();
    }
    if (found.tree.branches.empty()) {
        return Error{
            "Nothing in the volume is like a vessel: no branch is long enough. Lower the threshold or the "
            "shortest branch length."};
    }
    traced.tree = std::move(found.tree);
    traced.lumen = asStored(lumen, box, stored);
    if (!leftOut.value().empty()) {
        traced.warnings.push_back(leftOut.value());
    }
    if (found.openedLoops > 0) {
        traced.warnings.push_back(loopWarning(found.openedLoops));
    }
    return traced;
}

}   // namespace

Result<TracedVessels> traceMask(const VoxelMask& mask, const VesselTracingOptions& options,
                                const TracingObserver& observe)
{
    if (const std::string problem = problemWith(mask.geometry, mask.voxels.size()); !problem.empty()) {
        return Error{problem};
    }
    TracingProgress progress(observe);
    progress.enter("vessels", 0.0, 0.7);
    return traceLumen(maskOf(mask, [](std::uint8_t voxel) { return voxel != 0; }), mask.geometry, options, progress);
}

Result<TracedVessels> traceLabels(const LabelVolume& image, const std::vector<int>& labels,
                                  const VesselTracingOptions& options, const TracingObserver& observe)
{
    if (const std::string problem = problemWith(image.geometry, image.voxels.size()); !problem.empty()) {
        return Error{problem};
    }
    TracingProgress progress(observe);
    progress.enter("vessels", 0.0, 0.7);
    const std::set<int> asked(labels.begin(), labels.end());
    const auto isAsked = [&](std::uint16_t label) { return asked.empty() ? label != 0 : asked.contains(label); };
    return traceLumen(maskOf(image, isAsked), image.geometry, options, progress);
}

}   // namespace core
