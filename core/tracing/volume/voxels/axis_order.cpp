#include "core/tracing/volume/voxels/axis_order.h"

#include <cmath>

namespace angiopose::core {
namespace {

/// Returns, for each patient axis, the closest stored axis: the best of all six assignments.
std::array<int, 3> bestAssignment(const Eigen::Matrix3d& direction)
{
    constexpr std::array<std::array<int, 3>, 6> orders{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    std::array<int, 3> best = orders.front();
    double bestAgreement = -1.0;
    for (const std::array<int, 3>& order : orders) {
        const double agreement =
            std::abs(direction(0, order[0])) + std::abs(direction(1, order[1])) + std::abs(direction(2, order[2]));
        if (agreement > bestAgreement + 1e-9) {
            bestAgreement = agreement;
            best = order;
        }
    }
    return best;
}

}   // namespace

AxisOrder patientAxisOrder(const VolumeGeometry& stored)
{
    const std::array<std::ptrdiff_t, 3> storedStrides{1, stored.size.x(),
                                                      static_cast<std::ptrdiff_t>(stored.size.x()) * stored.size.y()};
    const std::array<int, 3> assignment = bestAssignment(stored.direction);
    AxisOrder order;
    Eigen::Vector3d corner = Eigen::Vector3d::Zero();   // stored voxel that becomes (0, 0, 0)
    for (int axis = 0; axis < 3; ++axis) {
        const int from = assignment[static_cast<std::size_t>(axis)];
        const bool flipped = stored.direction(axis, from) < 0.0;
        const std::ptrdiff_t stride = storedStrides[static_cast<std::size_t>(from)];
        order.geometry.size[axis] = stored.size[from];
        order.geometry.spacingMm[axis] = stored.spacingMm[from];
        order.geometry.direction.col(axis) = (flipped ? -1.0 : 1.0) * stored.direction.col(from);
        order.strides[static_cast<std::size_t>(axis)] = flipped ? -stride : stride;
        if (flipped) {
            order.first += stride * (stored.size[from] - 1);
            corner[from] = stored.size[from] - 1;
        }
    }
    order.geometry.originInPatient = stored.patientFromVoxel() * corner;
    return order;
}

VolumeGeometry crop(const VolumeGeometry& geometry, const VoxelBox& box)
{
    VolumeGeometry part = geometry;
    part.size = (box.high - box.low).cwiseMax(0);
    part.originInPatient = geometry.patientFromVoxel() * box.low.cast<double>();
    return part;
}

AxisOrder crop(const AxisOrder& order, const VoxelBox& box)
{
    AxisOrder part = order;
    part.geometry = crop(order.geometry, box);
    part.first = static_cast<std::ptrdiff_t>(order.stored(box.low.x(), box.low.y(), box.low.z()));
    return part;
}

VoxelBox enlarge(const VoxelBox& box, int margin, const VolumeGeometry& within)
{
    return {(box.low.array() - margin).max(0).matrix(), (box.high.array() + margin).min(within.size.array()).matrix()};
}

}   // namespace angiopose::core
