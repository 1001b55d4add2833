#include "core/tracing/volume/chosen/selected_lumen.h"

#include "core/tracing/volume/chosen/split_by_seeds.h"
#include "core/tracing/volume/voxels/voxel_components.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace angiopose::core {
namespace {

VoxelMask croppedMask(const VoxelMask& mask, const VoxelBox& box)
{
    VoxelMask part(crop(mask.geometry, box));
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

/// Adds the centerline points of the great vessel that lie in the lumen.
void addPointsInLumen(const VoxelMask& lumen, const GreatVessel& great, std::vector<Eigen::Vector3d>& points)
{
    for (const Trunk& trunk : great.trunks) {
        std::copy_if(trunk.pointsInPatient.begin(), trunk.pointsInPatient.end(), std::back_inserter(points),
                     [&](const Eigen::Vector3d& point) { return findVoxelNear(lumen, point).has_value(); });
    }
}

/// Returns the centerline points of the great vessels to trace; empty if there are seeds or no great vessels.
std::vector<Eigen::Vector3d> greatVesselPoints(const VoxelMask& lumen, const VesselTracingOptions& options,
                                               const std::vector<GreatVessel>& greatVessels)
{
    std::vector<Eigen::Vector3d> points;
    const std::size_t count =
        options.pieces == TracedPieces::All ? greatVessels.size() : std::min<std::size_t>(1, greatVessels.size());
    for (std::size_t n = 0; options.seedsInPatient.empty() && n < count; ++n) {
        addPointsInLumen(lumen, greatVessels[n], points);
    }
    return points;
}

}   // namespace

Result<SelectedLumen> selectLumen(VoxelMask whole, VesselTracingOptions options,
                                  const VoxelOpacification& opacification, const std::vector<GreatVessel>& greatVessels,
                                  TracingProgress& progress)
{
    const auto seeds = moveSeedsIntoLumen(whole, options.seedsInPatient);
    if (!seeds) {
        return seeds.error();
    }
    options.seedsInPatient = seeds.value().seedPoints;
    const std::vector<Eigen::Vector3d> found = greatVesselPoints(whole, options, greatVessels);
    auto excluded = selectComponents(whole, found.empty() ? options.seedsInPatient : found, options.pieces, progress);
    if (!excluded) {
        return excluded.error();
    }
    if (!progress.advance(0.0)) {
        return tracingCanceled();
    }
    SelectedLumen chosen;
    chosen.warnings = seeds.value().warnings;
    chosen.excluded = std::move(excluded).value();
    chosen.box = enlarge(boxOf(whole), 1, whole.geometry);
    progress.advance(selectedProgress);
    chosen.lumen = croppedMask(whole, chosen.box);
    whole = {};
    if (!found.empty() || !options.seedsInPatient.empty()) {
        chosen.startPointsInPatient = splitBySeeds(
            chosen.lumen, options, opacification ? shiftOrigin(opacification, chosen.box.low) : VoxelOpacification(),
            greatVessels, progress);
    }
    return chosen;
}

VoxelOpacification shiftOrigin(const VoxelOpacification& opacification, const Eigen::Vector3i& low)
{
    return [&opacification, low](int i, int j, int k) { return opacification(i + low.x(), j + low.y(), k + low.z()); };
}

}   // namespace angiopose::core
