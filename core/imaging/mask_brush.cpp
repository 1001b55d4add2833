#include "core/imaging/mask_brush.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace angiopose::core {
namespace {

double distanceToStep(const BrushStep& step, const Eigen::Vector3d& point)
{
    const Eigen::Vector3d stroke = step.toInPatient - step.fromInPatient;
    const double length2 = stroke.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp((point - step.fromInPatient).dot(stroke) / length2, 0.0, 1.0) : 0.0;
    return (point - step.fromInPatient - share * stroke).norm();
}

/// Collects the voxels that the brush would change.
class BrushCollector {
public:
    BrushCollector(const VoxelMask& mask, const MaskBrush& brush)
        : mask_(mask), brush_(brush), targetState_(brush.mode == BrushMode::Paint)
    {
        hasSameVoxels_ = brush.scan && isSameGrid(brush.scan->geometry, mask.geometry);
    }
    void take(const Eigen::Vector3i& voxel, const Eigen::Vector3d& pointInPatient)
    {
        const std::uint32_t place = voxelIndex(mask_.geometry, voxel);
        if ((mask_.voxels[place] != 0) != targetState_ && isAllowed(place, pointInPatient)) {
            found.push_back(place);
        }
    }

    VoxelIndices found;

private:
    bool isAllowed(std::uint32_t place, const Eigen::Vector3d& pointInPatient) const
    {
        if (!brush_.scan) {
            return true;
        }
        const auto value =
            hasSameVoxels_ ? std::optional(brush_.scan->value(place)) : valueAt(*brush_.scan, pointInPatient);
        return value && *value >= brush_.minValue;
    }

    const VoxelMask& mask_;
    const MaskBrush& brush_;
    bool targetState_;
    bool hasSameVoxels_ = false;
};

/// Index box of the voxels that a brush step may change.
struct VoxelBox {
    Eigen::Array3i low;
    Eigen::Array3i high;
};

VoxelBox boxAround(const BrushStep& step, double reachMm, const VolumeGeometry& geometry)
{
    const Eigen::Affine3d voxelFromPatient = geometry.patientFromVoxel().inverse();
    const Eigen::Vector3d from = voxelFromPatient * step.fromInPatient;
    const Eigen::Vector3d to = voxelFromPatient * step.toInPatient;
    const Eigen::Vector3d reach = reachMm * geometry.spacingMm.cwiseInverse();
    return {(from.cwiseMin(to) - reach).array().floor().cast<int>().max(0),
            (from.cwiseMax(to) + reach).array().ceil().cast<int>().min(geometry.size.array() - 1)};
}

/// Returns the parameters i at which the line `start + i * along` enters and leaves the ball of `radius` around the
/// origin, or a cylinder if the component along its axis was removed; nullopt if it misses.
std::optional<std::pair<double, double>> crossings(const Eigen::Vector3d& start, const Eigen::Vector3d& along,
                                                   double radius)
{
    const double step2 = along.squaredNorm();
    if (step2 <= 0.0) {
        return {};
    }
    const double middle = -start.dot(along) / step2;
    const double discriminant = middle * middle - (start.squaredNorm() - radius * radius) / step2;
    return discriminant < 0.0
               ? std::nullopt
               : std::optional(std::pair(middle - std::sqrt(discriminant), middle + std::sqrt(discriminant)));
}

/// The part of a voxel row `start + i * along` inside a brush step, from i = first to last; empty if first > last.
struct RowRange {
    double first = std::numeric_limits<double>::infinity();
    double last = -first;

    void widen(double i)
    {
        first = std::min(first, i);
        last = std::max(last, i);
    }
};

/// Returns the part of the row inside the step. The step is a capsule and therefore convex: the row enters and leaves
/// it at one of the end balls or at the tube between them.
RowRange rangeInCapsule(const BrushStep& step, double radiusMm, const Eigen::Vector3d& start,
                        const Eigen::Vector3d& along)
{
    RowRange range;
    for (const Eigen::Vector3d& end : {step.fromInPatient, step.toInPatient}) {
        if (const auto ball = crossings(start - end, along, radiusMm)) {
            range.widen(ball->first);
            range.widen(ball->second);
        }
    }
    const Eigen::Vector3d stroke = step.toInPatient - step.fromInPatient;
    const double length2 = stroke.squaredNorm();
    if (length2 <= 0.0) {
        return range;
    }
    const auto across = [&](const Eigen::Vector3d& v) { return Eigen::Vector3d(v - v.dot(stroke) / length2 * stroke); };
    if (const auto tube = crossings(across(start - step.fromInPatient), across(along), radiusMm)) {
        for (const double i : {tube->first, tube->second}) {
            const double share = (start + i * along - step.fromInPatient).dot(stroke) / length2;
            if (share >= 0.0 && share <= 1.0) {
                range.widen(i);
            }
        }
    }
    return range;
}

/// Collects the voxels that lie between the pixels of a slice that is coarser than the mask.
void takeBetweenPixels(const VoxelMask& mask, const SliceGrid& slice, const MaskBrush& brush, const BrushStep& step,
                       BrushCollector& collector)
{
    const double half = halfThicknessMm(slice);
    const Eigen::Affine3d patientFromVoxel = mask.geometry.patientFromVoxel();
    const VoxelBox box = boxAround(step, brush.radiusMm + half, mask.geometry);
    for (int k = box.low.z(); k <= box.high.z(); ++k) {
        for (int j = box.low.y(); j <= box.high.y(); ++j) {
            for (int i = box.low.x(); i <= box.high.x(); ++i) {
                const Eigen::Vector3d point = patientFromVoxel * Eigen::Vector3d(i, j, k);
                const double before = slice.distanceMm(point);
                if (std::abs(before) <= half && distanceToStep(step, point - before * slice.normal) <= brush.radiusMm) {
                    collector.take({i, j, k}, point);
                }
            }
        }
    }
}

}   // namespace

VoxelIndices brushSlice(const VoxelMask& mask, const SliceGrid& slice, const MaskBrush& brush, const BrushStep& step)
{
    const Eigen::Vector2d from = slice.pixelOf(step.fromInPatient);
    const Eigen::Vector2d to = slice.pixelOf(step.toInPatient);
    const Eigen::Vector2d reach(brush.radiusMm / slice.columnStep.norm(), brush.radiusMm / slice.rowStep.norm());
    const Eigen::Array2i low = (from.cwiseMin(to) - reach).array().floor().cast<int>().max(0);
    const Eigen::Array2i high =
        (from.cwiseMax(to) + reach).array().ceil().cast<int>().min(Eigen::Array2i(slice.width - 1, slice.height - 1));
    const Eigen::Affine3d voxelFromPatient = mask.geometry.patientFromVoxel().inverse();
    BrushCollector collector(mask, brush);
    for (int row = low.y(); row <= high.y(); ++row) {
        for (int column = low.x(); column <= high.x(); ++column) {
            const Eigen::Vector3d point = slice.pointAt({column, row});
            const Eigen::Vector3i voxel = (voxelFromPatient * point).array().round().cast<int>();
            if (distanceToStep(step, point) <= brush.radiusMm && mask.geometry.contains(voxel)) {
                collector.take(voxel, point);
            }
        }
    }
    takeBetweenPixels(mask, slice, brush, step, collector);
    return std::move(collector.found);
}

VoxelIndices brushVolume(const VoxelMask& mask, const MaskBrush& brush, const BrushStep& step)
{
    constexpr double boundaryTolerance = 1e-9;   // tolerance, in voxels, that includes voxels on the boundary
    const Eigen::Affine3d patientFromVoxel = mask.geometry.patientFromVoxel();
    const Eigen::Vector3d along = patientFromVoxel.linear().col(0);
    const VoxelBox box = boxAround(step, brush.radiusMm, mask.geometry);
    BrushCollector collector(mask, brush);
    for (int k = box.low.z(); k <= box.high.z(); ++k) {
        for (int j = box.low.y(); j <= box.high.y(); ++j) {
            const Eigen::Vector3d start = patientFromVoxel * Eigen::Vector3d(0, j, k);
            const RowRange range = rangeInCapsule(step, brush.radiusMm, start, along);
            if (range.first > range.last) {
                continue;
            }
            const int first = static_cast<int>(std::ceil(std::max(range.first - boundaryTolerance, 1.0 * box.low.x())));
            const int last = static_cast<int>(std::floor(std::min(range.last + boundaryTolerance, 1.0 * box.high.x())));
            for (int i = first; i <= last; ++i) {
                collector.take({i, j, k}, start + i * along);
            }
        }
    }
    return std::move(collector.found);
}

}   // namespace angiopose::core
