#include "core/tracing/volume/stents/stent_width.h"

#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/distance_map.h"

#include <cmath>

namespace angiopose::core {
namespace {

constexpr double clearMm = 5.0;
constexpr double farMm = 7.0;
/// Minimum lumen volume at that distance, relative to the struts; thin stents reach 0.2, beyond their ends.
constexpr double minShareOfWires = 0.35;

}   // namespace

bool isWideStent(const VoxelPiece& wires, const VoxelMask& flags, std::uint8_t core, int threads,
                 TracingProgress& progress)
{
    const VoxelBox box = boxAround(wires, flags.geometry, farMm);
    VoxelMask others(cropped(flags.geometry, box), 1);
    for (const std::uint32_t voxel : wires) {
        const Eigen::Vector3i at = flags.geometry.voxelAt(voxel) - box.low;
        others.at(at.x(), at.y(), at.z()) = 0;
    }
    const DistanceMap toWires = distanceMap(others, threads, progress);
    std::size_t clear = 0;
    std::size_t voxel = 0;
    const Eigen::Vector3i& size = others.geometry.size;
    for (int k = 0; k < size.z(); ++k) {
        for (int j = 0; j < size.y(); ++j) {
            for (int i = 0; i < size.x(); ++i, ++voxel) {
                const double mm = toWires.mm(voxel);
                const bool isCore = (flags.at(i + box.low.x(), j + box.low.y(), k + box.low.z()) & core) != 0;
                clear += isCore && mm >= clearMm && mm <= farMm ? 1 : 0;
            }
        }
    }
    return static_cast<double>(clear) >= minShareOfWires * static_cast<double>(wires.size());
}

}   // namespace angiopose::core
