#include "core/tracing/volume/stents/stent_width.h"

#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/distance_map.h"

#include <cmath>

namespace angiopose::core {
namespace {

constexpr double minDistanceMm = 5.0;
constexpr double maxDistanceMm = 7.0;
/// Minimum lumen volume at that distance, relative to the struts; thin stents reach 0.2, beyond their ends.
constexpr double minFractionOfStruts = 0.35;

}   // namespace

bool isWideStent(const VoxelComponent& wires, const VoxelMask& flags, std::uint8_t core, int threads,
                 TracingProgress& progress)
{
    const VoxelBox box = enlargedBox(wires, flags.geometry, maxDistanceMm);
    VoxelMask others(crop(flags.geometry, box), 1);
    for (const std::uint32_t voxel : wires) {
        const Eigen::Vector3i at = flags.geometry.voxelAt(voxel) - box.low;
        others.at(at.x(), at.y(), at.z()) = 0;
    }
    const DistanceMap toStruts = distanceMap(others, threads, progress);
    std::size_t distantCount = 0;
    std::size_t voxel = 0;
    const Eigen::Vector3i& size = others.geometry.size;
    for (int k = 0; k < size.z(); ++k) {
        for (int j = 0; j < size.y(); ++j) {
            for (int i = 0; i < size.x(); ++i, ++voxel) {
                const double mm = toStruts.mm(voxel);
                const bool isCore = (flags.at(i + box.low.x(), j + box.low.y(), k + box.low.z()) & core) != 0;
                distantCount += isCore && mm >= minDistanceMm && mm <= maxDistanceMm ? 1 : 0;
            }
        }
    }
    return static_cast<double>(distantCount) >= minFractionOfStruts * static_cast<double>(wires.size());
}

}   // namespace angiopose::core
