#include "core/tracing/volume/great_vessels/skull.h"

#include "core/support/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr double blockMm = 2.5;
constexpr double minBoneFill = 1.5;   ///< above the lumen level by half of the lumen contrast
constexpr double minBoneShare = 0.25;   ///< minimum bone fraction of a block's voxels
constexpr double maxAirFill = -1.0;
constexpr int sectors = 48;
constexpr int minSectors = 44;   ///< minimum number of sectors with bone; ribs and hips close fewer
constexpr double minRingMm = 30.0;
constexpr double maxRingMm = 130.0;
constexpr double minSoftShare = 0.8;   ///< minimum soft-tissue fraction of the enclosed area; a chest contains air
constexpr double innerShare = 0.75;   ///< fraction of the ring's radius that counts as enclosed
constexpr double minHeightMm = 20.0;   ///< total height of closed rings
constexpr double maxTableDistanceMm = 4.5;   ///< maximum distance from the wall of a venous sinus to bone
constexpr double minWithinMm = 25.0;   ///< minimum length within the vault for evaluating a course
constexpr double maxAdjacentInArtery = 0.5;   ///< maximum fraction of that length; the petrous bone borders the carotid
constexpr double minAdjacentInSinus = 0.6;
constexpr double minLateOpacification = 0.75;   ///< minimum opacification of a sinus that enhances like the arteries
constexpr double maxOutward = 0.45;   ///< maximum relative distance from the middle of the head
constexpr double entryMm = 25.0;   ///< maximum distance from the lower face of the scan or the base of the vault

std::size_t sectorOf(const Eigen::Vector2d& offset)
{
    const double turn = (std::atan2(offset.y(), offset.x()) + std::numbers::pi) / (2.0 * std::numbers::pi);
    return std::min<std::size_t>(sectors - 1, static_cast<std::size_t>(turn * sectors));
}

enum class Block : std::uint8_t { Soft, Bone, Air };

/// Classifies one block of `per` voxels along each axis.
Block blockAt(const Eigen::Array3i& block, const Eigen::Array3i& per, const VoxelOpacification& fill)
{
    int bone = 0;
    int sampledCount = 0;
    double sum = 0.0;
    for (int n = 0; n < per.prod(); ++n) {
        const Eigen::Array3i in(n % per.x(), n / per.x() % per.y(), n / (per.x() * per.y()));
        if ((per > 2).any() && in.x() % 2 + in.y() % 2 + in.z() % 2 > 0) {
            continue;   // sampling every second voxel is enough
        }
        const Eigen::Array3i at = block * per + in;
        const double share = fill(at.x(), at.y(), at.z());
        bone += share > minBoneFill ? 1 : 0;
        sum += share;
        ++sampledCount;
    }
    return bone >= minBoneShare * sampledCount ? Block::Bone
           : sum < maxAirFill * sampledCount   ? Block::Air
                                               : Block::Soft;
}

VoxelGrid<Block> blocksOf(const VolumeGeometry& grid, const VoxelOpacification& fill, int threads,
                          TracingProgress& progress)
{
    const Eigen::Array3i per = (blockMm / grid.spacingMm.array()).round().max(1.0).cast<int>();
    VolumeGeometry coarse = grid;
    coarse.size = (grid.size.array() / per).max(1);
    coarse.spacingMm = grid.spacingMm.cwiseProduct(per.cast<double>().matrix());
    coarse.originInPatient = grid.patientFromVoxel() * (0.5 * (per.cast<double>() - 1.0)).matrix();
    VoxelGrid<Block> blocks(coarse);
    const auto fillSlice = [&](std::size_t slice) {
        const auto k = static_cast<int>(slice);
        for (int j = 0; j < coarse.size.y(); ++j) {
            for (int i = 0; i < coarse.size.x(); ++i) {
                blocks.at(i, j, k) = blockAt({i, j, k}, per, fill);
            }
        }
    };
    parallelFor(static_cast<std::size_t>(coarse.size.z()), threads, fillSlice,
                [&](double) { return progress.advance(0.0); });
    return blocks;
}

template <class Visit>
void forEachBlock(const VoxelGrid<Block>& blocks, int k, const Visit& visit)
{
    for (int j = 0; j < blocks.geometry.size.y(); ++j) {
        for (int i = 0; i < blocks.geometry.size.x(); ++i) {
            visit(Eigen::Vector2d(i, j), blocks.at(i, j, k));
        }
    }
}

struct BoneRing {
    bool isClosed = false;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    std::vector<double> radius = std::vector<double>(sectors, 0.0);
};

BoneRing findRing(const VoxelGrid<Block>& blocks, int k)
{
    BoneRing ring;
    int bones = 0;
    forEachBlock(blocks, k, [&](const Eigen::Vector2d& at, Block block) {
        if (block == Block::Bone) {
            ring.middle += at;
            ++bones;
        }
    });
    if (bones < sectors) {
        return ring;
    }
    ring.middle /= bones;
    forEachBlock(blocks, k, [&](const Eigen::Vector2d& at, Block block) {
        if (block == Block::Bone) {
            double& radius = ring.radius[sectorOf(at - ring.middle)];
            radius = std::max(radius, (at - ring.middle).norm());
        }
    });
    const double unitMm = blocks.geometry.spacingMm.x();
    const auto covered = std::ranges::count_if(
        ring.radius, [&](double radius) { return radius * unitMm >= minRingMm && radius * unitMm <= maxRingMm; });
    int soft = 0;
    int within = 0;
    forEachBlock(blocks, k, [&](const Eigen::Vector2d& at, Block block) {
        if ((at - ring.middle).norm() < innerShare * ring.radius[sectorOf(at - ring.middle)]) {
            ++within;
            soft += block == Block::Soft ? 1 : 0;
        }
    });
    ring.isClosed = covered >= minSectors && soft >= minSoftShare * within;
    return ring;
}

/// Returns the lowest and the highest centerline point.
std::pair<Eigen::Vector3d, Eigen::Vector3d> endsOf(const GreatVessel& great)
{
    Eigen::Vector3d low = great.trunks.front().pointsInPatient.front();
    Eigen::Vector3d high = low;
    for (const Trunk& trunk : great.trunks) {
        for (const Eigen::Vector3d& point : trunk.pointsInPatient) {
            low = point.z() < low.z() ? point : low;
            high = point.z() > high.z() ? point : high;
        }
    }
    return {low, high};
}

Skull::Course courseOf(const GreatVessel& great, const Skull& skull)
{
    Skull::Course course;
    for (const Trunk& trunk : great.trunks) {
        const Skull::Course trunkCourse = skull.courseOf(trunk.pointsInPatient, trunk.radiusMm);
        course.withinMm += trunkCourse.withinMm;
        course.adjacentMm += trunkCourse.adjacentMm;
    }
    return course;
}

bool isSinus(const Skull::Course& course)
{
    return course.withinMm >= minWithinMm && course.adjacentMm >= minAdjacentInSinus * course.withinMm;
}

double fillOf(const GreatVessel& great)
{
    return great.trunks.front().fill;
}

}   // namespace

const Skull::Ring* Skull::ringAt(const Eigen::Vector3d& block) const
{
    const auto k = static_cast<std::ptrdiff_t>(std::lround(block.z()));
    if (k < 0 || k >= static_cast<std::ptrdiff_t>(rings_.size()) || !rings_[static_cast<std::size_t>(k)].isClosed) {
        return nullptr;
    }
    return &rings_[static_cast<std::size_t>(k)];
}

bool Skull::isNextToInnerTable(const Eigen::Vector3d& pointInPatient, double radiusMm) const
{
    const Eigen::Vector3d block = blockFromPatient_ * pointInPatient;
    const Eigen::Vector3i at = block.array().round().cast<int>();
    return ringAt(block) != nullptr && toBone_.geometry.contains(at) &&
           toBone_.mm(toBone_.geometry.index(at.x(), at.y(), at.z())) <= radiusMm + maxTableDistanceMm;
}

std::optional<double> Skull::radialPosition(const Eigen::Vector3d& pointInPatient) const
{
    const Eigen::Vector3d block = blockFromPatient_ * pointInPatient;
    const Ring* ring = ringAt(block);
    if (ring == nullptr) {
        return {};
    }
    const Eigen::Vector2d offset = block.head<2>() - ring->middle;
    return offset.norm() / std::max(1.0, ring->radius[sectorOf(offset)]);
}

Skull::Course Skull::courseOf(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& radiusMm) const
{
    Course course;
    for (std::size_t n = 1; n < points.size(); ++n) {
        if (ringAt(blockFromPatient_ * points[n]) != nullptr) {
            const double stepMm = (points[n] - points[n - 1]).norm();
            course.withinMm += stepMm;
            course.adjacentMm += isNextToInnerTable(points[n], radiusMm[n]) ? stepMm : 0.0;
        }
    }
    return course;
}

std::optional<Skull> findSkull(const VolumeGeometry& grid, const VoxelOpacification& fill, int threads,
                               TracingProgress& progress)
{
    const VoxelGrid<Block> blocks = blocksOf(grid, fill, threads, progress);
    Skull skull;
    double heightMm = 0.0;
    for (int k = 0; k < blocks.geometry.size.z(); ++k) {
        BoneRing ring = findRing(blocks, k);
        heightMm += ring.isClosed ? blocks.geometry.spacingMm.z() : 0.0;
        skull.rings_.push_back({ring.isClosed, ring.middle, std::move(ring.radius)});
    }
    if (heightMm < minHeightMm || progress.isStopped()) {
        return {};
    }
    VoxelMask others(blocks.geometry);
    std::ranges::transform(blocks.voxels, others.voxels.begin(),
                           [](Block block) { return static_cast<std::uint8_t>(block == Block::Bone ? 0 : 1); });
    skull.toBone_ = distanceMap(others, threads, progress);
    skull.blockFromPatient_ = blocks.geometry.patientFromVoxel().inverse();
    return skull;
}

std::vector<Eigen::Vector3d> sinusPoints(const std::vector<GreatVessel>& great, const Skull& skull)
{
    std::vector<Eigen::Vector3d> places;
    for (const GreatVessel& vessel : great) {
        for (const Trunk& trunk : vessel.trunks) {
            if (isSinus(skull.courseOf(trunk.pointsInPatient, trunk.radiusMm))) {
                places.insert(places.end(), trunk.pointsInPatient.begin(), trunk.pointsInPatient.end());
            }
        }
    }
    return places;
}

std::vector<GreatVessel> selectHeadArteries(std::vector<GreatVessel> great, const Skull& skull,
                                            const VolumeGeometry& grid)
{
    const bool isLate = std::ranges::any_of(great, [&](const GreatVessel& vessel) {
        return isSinus(courseOf(vessel, skull)) && fillOf(vessel) >= minLateOpacification;
    });
    const double faceMm = (grid.patientFromVoxel() * Eigen::Vector3d::Zero()).z();
    std::erase_if(great, [&](const GreatVessel& vessel) {
        const Skull::Course course = courseOf(vessel, skull);
        const auto [low, high] = endsOf(vessel);
        const bool isNextToBone =
            course.withinMm >= minWithinMm && course.adjacentMm > maxAdjacentInArtery * course.withinMm;
        const bool entersFromBelow = low.z() <= faceMm + entryMm || !skull.radialPosition(low);
        const bool endsInMiddle = skull.radialPosition(high).value_or(1.0) <= maxOutward;
        return isNextToBone || !entersFromBelow || (isLate && !endsInMiddle);
    });
    return great;
}

}   // namespace angiopose::core
