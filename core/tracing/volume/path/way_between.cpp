#include "core/tracing/volume/path/way_between.h"

#include "core/imaging/mark_ball.h"
#include "core/imaging/reduce_volume.h"
#include "core/tracing/volume/path/cheapest_path.h"
#include "core/tracing/volume/path/voxel_cost.h"

#include <algorithm>
#include <limits>

namespace angiopose::core {
namespace {

constexpr std::size_t soonSettled = 30'000;   // enough for a path through thin vessels only
constexpr std::size_t maxSettled = 3'000'000;
constexpr double coarsestMm = 3.2;   // maximum side of the blocks
constexpr double nearInBlocks = 2.5;   // search distance around the path over blocks
constexpr double minNearMm = 4.0;

/// Expected look of the vessels between both ends, linearly interpolated.
class LookOnTheWay {
public:
    LookOnTheWay(const Eigen::Vector3d& fromMm, const VesselLook& from, const Eigen::Vector3d& toMm,
                 const VesselLook& to)
        : fromMm_(fromMm), way_(toMm - fromMm), from_(from), to_(to)
    {
    }

    VesselLook at(const Eigen::Vector3d& pointMm) const
    {
        const double share = std::clamp((pointMm - fromMm_).dot(way_) / std::max(way_.squaredNorm(), 1e-12), 0.0, 1.0);
        return {from_.blood + share * (to_.blood - from_.blood), from_.tissue + share * (to_.tissue - from_.tissue)};
    }

private:
    Eigen::Vector3d fromMm_;
    Eigen::Vector3d way_;
    VesselLook from_;
    VesselLook to_;
};

VoxelCost costBetween(const PathGround& ground, const PathEnd& from, const PathEnd& to)
{
    const Eigen::Vector3d spacing = ground.volume().geometry.spacingMm;
    const LookOnTheWay look(from.voxel.cast<double>().cwiseProduct(spacing), from.look,
                            to.voxel.cast<double>().cwiseProduct(spacing), to.look);
    return {[&ground, look, spacing](const Eigen::Vector3i& voxel) {
                return costOfVoxel(ground, voxel, look.at(voxel.cast<double>().cwiseProduct(spacing)));
            },
            cheapestPerMm};
}

/// Block size in voxels: twice the shortest voxel side, approximately cubic.
Eigen::Vector3i blockOf(const VolumeGeometry& grid)
{
    const double sideMm = 2.0 * grid.spacingMm.minCoeff();
    return (sideMm / grid.spacingMm.array()).round().max(1.0).cast<int>();
}

PathEnd endInBlocks(const PathGround& blocks, const Eigen::Vector3i& voxel)
{
    PathEnd end;
    end.voxel = voxel;
    end.look = blocks.lookAt(voxel);
    end.look.blood = std::max(end.look.blood, end.look.tissue + 1.0);
    return end;
}

/// Blocks near the path over blocks.
VoxelMask nearWay(const std::vector<Eigen::Vector3i>& way, const VolumeGeometry& blocks)
{
    VoxelMask near(blocks);
    const double reachMm = std::max(minNearMm, nearInBlocks * blocks.spacingMm.maxCoeff());
    for (const Eigen::Vector3i& block : way) {
        markBall(blocks.patientFromVoxel() * block.cast<double>(), reachMm, near);
    }
    return near;
}

std::vector<Eigen::Vector3i> wayByBlocks(const PathGround& ground, const PathEnd& from, const PathEnd& to,
                                         const VoxelCost& cost, TracingProgress& progress)
{
    const VolumeGeometry& grid = ground.volume().geometry;
    const Eigen::Vector3i block = blockOf(grid);
    const VoxelRange range = searchedRange(grid, from.voxel, to.voxel);
    const auto means = meansOfBlocks(ground.volume(), range, block, [&] { return progress.advance(0.0); });
    if (!means) {
        return {};
    }
    const PathGround blocks(*means);
    const auto blockAt = [&](const Eigen::Vector3i& voxel) {
        return ((voxel - range.low).array() / block.array()).matrix().eval();
    };
    const std::vector<Eigen::Vector3i> way =
        wayBetween(blocks, endInBlocks(blocks, blockAt(from.voxel)), endInBlocks(blocks, blockAt(to.voxel)), progress);
    if (way.empty()) {
        return {};
    }
    const VoxelMask near = nearWay(way, means->geometry);
    const VoxelCost nearby{[&](const Eigen::Vector3i& voxel) {
                               const Eigen::Vector3i at = blockAt(voxel);
                               return near.at(at.x(), at.y(), at.z()) != 0 ? cost.perMm(voxel)
                                                                           : std::numeric_limits<double>::infinity();
                           },
                           cost.minPerMm};
    return cheapestPath(grid, from.voxel, to.voxel, nearby, maxSettled, progress).voxels;
}

}   // namespace

std::vector<Eigen::Vector3i> wayBetween(const PathGround& ground, const PathEnd& from, const PathEnd& to,
                                        TracingProgress& progress)
{
    const VolumeGeometry& grid = ground.volume().geometry;
    const VoxelCost cost = costBetween(ground, from, to);
    const bool isCoarsest = 2.0 * grid.spacingMm.minCoeff() > coarsestMm;
    CheapestPath path = cheapestPath(grid, from.voxel, to.voxel, cost, isCoarsest ? maxSettled : soonSettled, progress);
    return path.isCutShort && !isCoarsest ? wayByBlocks(ground, from, to, cost, progress) : std::move(path.voxels);
}

}   // namespace angiopose::core
