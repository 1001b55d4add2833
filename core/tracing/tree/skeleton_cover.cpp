#include "core/tracing/tree/skeleton_cover.h"

#include "core/tracing/volume/voxels/chosen_pieces.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double followedVoxels = 2.0;
constexpr double stepOfCurve = 0.5;   ///< sampling step, relative to the smallest voxel side

/// Clears the voxels near `at` (in voxel coordinates).
void clearAround(VoxelMask& missed, const Eigen::Vector3d& at)
{
    const VolumeGeometry& grid = missed.geometry;
    const Eigen::Vector3i low = (at.array() - followedVoxels).ceil().max(0.0).cast<int>();
    const Eigen::Vector3i high =
        (at.array() + followedVoxels).floor().min(grid.size.cast<double>().array() - 1.0).cast<int>();
    for (int k = low.z(); k <= high.z(); ++k) {
        for (int j = low.y(); j <= high.y(); ++j) {
            for (int i = low.x(); i <= high.x(); ++i) {
                if ((Eigen::Vector3d(i, j, k) - at).squaredNorm() <= followedVoxels * followedVoxels) {
                    missed.at(i, j, k) = 0;
                }
            }
        }
    }
}

}   // namespace

SkeletonCover skeletonCover(const VolumeGeometry& grid, const std::vector<std::size_t>& skeleton,
                            const VesselTree& tree)
{
    VoxelMask missed(grid);
    for (const std::size_t voxel : skeleton) {
        missed.voxels[voxel] = 1;
    }
    const Eigen::Affine3d voxelFromPatient = grid.patientFromVoxel().inverse();
    for (const VesselBranch& branch : resampled(tree, stepOfCurve * grid.spacingMm.minCoeff()).branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            clearAround(missed, voxelFromPatient * point);
        }
    }
    VoxelMask whole(grid);
    for (const std::size_t voxel : skeleton) {
        whole.voxels[voxel] = 1;
    }
    std::size_t all = 0;
    std::size_t left = 0;
    for (const VoxelPiece& piece : piecesOf(whole)) {
        const auto its = static_cast<std::size_t>(
            std::ranges::count_if(piece, [&](std::uint32_t voxel) { return missed.voxels[voxel] != 0; }));
        const bool isTraced = its < piece.size();
        for (const std::uint32_t voxel : piece) {   // components without any branch are reported elsewhere
            missed.voxels[voxel] = isTraced ? missed.voxels[voxel] : std::uint8_t{0};
        }
        all += isTraced ? piece.size() : 0;
        left += isTraced ? its : 0;
    }
    SkeletonCover cover;
    if (left > 0) {
        cover.share = 1.0 - static_cast<double>(left) / static_cast<double>(all);
        cover.missedInPatient = pieceOf(piecesOf(missed).front(), grid).placeInPatient;
    }
    return cover;
}

}   // namespace angiopose::core
