#include "core/imaging/mask_edit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double withinSlice = 0.499;   // of its thickness: the slice beside begins there

std::uint32_t placeOf(const VolumeGeometry& geometry, const Eigen::Vector3i& voxel)
{
    return static_cast<std::uint32_t>(geometry.index(voxel.x(), voxel.y(), voxel.z()));
}

double distanceToStep(const BrushStep& step, const Eigen::Vector3d& point)
{
    const Eigen::Vector3d way = step.toInPatient - step.fromInPatient;
    const double length2 = way.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp((point - step.fromInPatient).dot(way) / length2, 0.0, 1.0) : 0.0;
    return (point - step.fromInPatient - share * way).norm();
}

/// Takes the voxels that the brush would change.
class Collector {
public:
    Collector(const VoxelMask& mask, const MaskBrush& brush)
        : mask_(mask), brush_(brush), wanted_(brush.aim == MaskAim::Paint)
    {
        hasSameVoxels_ = brush.scan && isSameGrid(brush.scan->geometry, mask.geometry);
    }
    void take(const Eigen::Vector3i& voxel, const Eigen::Vector3d& pointInPatient)
    {
        const std::uint32_t place = placeOf(mask_.geometry, voxel);
        if ((mask_.voxels[place] != 0) != wanted_ && isAllowed(place, pointInPatient)) {
            found.push_back(place);
        }
    }

    VoxelPlaces found;

private:
    bool isAllowed(std::uint32_t place, const Eigen::Vector3d& pointInPatient) const
    {
        if (!brush_.scan) {
            return true;
        }
        const auto value =
            hasSameVoxels_ ? std::optional(brush_.scan->value(place)) : valueAt(*brush_.scan, pointInPatient);
        return value && *value >= brush_.leastValue;
    }

    const VoxelMask& mask_;
    const MaskBrush& brush_;
    bool wanted_;
    bool hasSameVoxels_ = false;
};

/// The pixels of a slice that lie inside an outline, by the even-odd rule at their centres.
std::vector<std::uint8_t> filled(const SliceGrid& slice, const std::vector<Eigen::Vector2d>& outline)
{
    std::vector<std::uint8_t> inside(static_cast<std::size_t>(slice.width) * static_cast<std::size_t>(slice.height));
    std::vector<double> crossings;
    for (int row = 0; row < slice.height; ++row) {
        crossings.clear();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Eigen::Vector2d& a = outline[i];
            const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
            if ((a.y() <= row) != (b.y() <= row)) {
                crossings.push_back(a.x() + (row - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
            }
        }
        std::ranges::sort(crossings);
        for (std::size_t c = 0; c + 1 < crossings.size(); c += 2) {
            const int first = std::max(0, static_cast<int>(std::ceil(crossings[c])));
            const int last = std::min(slice.width - 1, static_cast<int>(std::floor(crossings[c + 1])));
            for (int column = first; column <= last; ++column) {
                inside[static_cast<std::size_t>(row) * static_cast<std::size_t>(slice.width) +
                       static_cast<std::size_t>(column)] = 1;
            }
        }
    }
    return inside;
}

/// Which side of the outline a pixel of the slice lies on; beyond the slice it is outside.
class Sides {
public:
    Sides(const MaskCut& cut) : slice_(cut.slice), inside_(filled(cut.slice, cut.outline)) {}
    CutSide at(int column, int row) const
    {
        const bool isThere = column >= 0 && row >= 0 && column < slice_.width && row < slice_.height;
        const auto pixel =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(slice_.width) + static_cast<std::size_t>(column);
        return isThere && inside_[pixel] != 0 ? CutSide::Inside : CutSide::Outside;
    }

private:
    const SliceGrid& slice_;
    std::vector<std::uint8_t> inside_;
};

/// Those that the slice shows as its pixels.
VoxelPlaces cutInPixels(const VoxelMask& mask, const MaskCut& cut, const Sides& sides)
{
    const Eigen::Affine3d voxelFromPatient = mask.geometry.patientFromVoxel().inverse();
    VoxelPlaces found;
    for (int row = 0; row < cut.slice.height; ++row) {
        for (int column = 0; column < cut.slice.width; ++column) {
            const Eigen::Vector3d point = cut.slice.pointAt({column, row});
            const Eigen::Vector3i voxel = (voxelFromPatient * point).array().round().cast<int>();
            if (sides.at(column, row) == cut.side && mask.geometry.contains(voxel)) {
                const std::uint32_t place = placeOf(mask.geometry, voxel);
                if (mask.voxels[place] != 0) {
                    found.push_back(place);
                }
            }
        }
    }
    return found;
}

VoxelPlaces cutInDepth(const VoxelMask& mask, const MaskCut& cut, const Sides& sides, double halfDepthMm)
{
    const Eigen::Affine3d patientFromVoxel = mask.geometry.patientFromVoxel();
    VoxelPlaces found;
    for (std::size_t place = 0; place < mask.voxels.size(); ++place) {
        if (mask.voxels[place] == 0) {
            continue;
        }
        const Eigen::Vector3d point = patientFromVoxel * mask.geometry.voxelAt(place).cast<double>();
        const Eigen::Vector2d pixel = cut.slice.pixelOf(point);
        if (std::abs(cut.slice.distanceMm(point)) <= halfDepthMm &&
            sides.at(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y()))) == cut.side) {
            found.push_back(static_cast<std::uint32_t>(place));
        }
    }
    return found;
}

/// A mask finer than the slice has voxels between its pixels, one coarser has them beside the slice.
VoxelPlaces cutInSlice(const VoxelMask& mask, const MaskCut& cut, const Sides& sides)
{
    VoxelPlaces found = cutInPixels(mask, cut, sides);
    const VoxelPlaces between = cutInDepth(mask, cut, sides, withinSlice * cut.slice.thicknessMm);
    found.insert(found.end(), between.begin(), between.end());
    std::ranges::sort(found);
    const auto twice = std::ranges::unique(found);
    found.erase(twice.begin(), twice.end());
    return found;
}

/// Where a row of voxels runs inside the step of a ball: indices from first to last, none where first > last.
struct RowRange {
    int first = 0;
    int last = -1;
};

/// The row is `start + i * along`. A capsule is convex: the least and the greatest place in its ends and its middle.
RowRange rangeInCapsule(const BrushStep& step, double radiusMm, const Eigen::Vector3d& start,
                        const Eigen::Vector3d& along, int count)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    const auto widen = [&](double i) {
        low = std::min(low, i);
        high = std::max(high, i);
    };
    for (const Eigen::Vector3d& end : {step.fromInPatient, step.toInPatient}) {
        const Eigen::Vector3d away = start - end;
        const double half = away.dot(along) / along.squaredNorm();
        const double rest = half * half - (away.squaredNorm() - radiusMm * radiusMm) / along.squaredNorm();
        if (rest >= 0.0) {
            widen(-half - std::sqrt(rest));
            widen(-half + std::sqrt(rest));
        }
    }
    const Eigen::Vector3d way = step.toInPatient - step.fromInPatient;
    const double length2 = way.squaredNorm();
    if (length2 > 0.0) {
        const auto across = [&](const Eigen::Vector3d& v) { return Eigen::Vector3d(v - v.dot(way) / length2 * way); };
        const Eigen::Vector3d a = across(start - step.fromInPatient);
        const Eigen::Vector3d d = across(along);
        const double half = d.squaredNorm() > 0.0 ? a.dot(d) / d.squaredNorm() : 0.0;
        const double rest =
            d.squaredNorm() > 0.0 ? half * half - (a.squaredNorm() - radiusMm * radiusMm) / d.squaredNorm() : -1.0;
        for (const double sign : {-1.0, 1.0}) {
            const double i = -half + sign * std::sqrt(std::max(rest, 0.0));
            const double share = (start + i * along - step.fromInPatient).dot(way) / length2;
            if (rest >= 0.0 && share >= 0.0 && share <= 1.0) {
                widen(i);
            }
        }
    }
    if (low > high) {
        return {};
    }
    constexpr double hair = 1e-9;   // voxels that lie on the rim are in it
    return {std::max(0, static_cast<int>(std::ceil(std::max(low, -1.0) - hair))),
            static_cast<int>(std::floor(std::min(high, count - 1.0) + hair))};
}

/// The part of a brush's step that a slice cuts of voxels between its pixels.
void takeBetween(const VoxelMask& mask, const SliceGrid& slice, const MaskBrush& brush, const BrushStep& step,
                 Collector& collector)
{
    const double half = withinSlice * slice.thicknessMm;
    const Eigen::Affine3d patientFromVoxel = mask.geometry.patientFromVoxel();
    const Eigen::Affine3d voxelFromPatient = patientFromVoxel.inverse();
    const Eigen::Vector3d from = voxelFromPatient * step.fromInPatient;
    const Eigen::Vector3d to = voxelFromPatient * step.toInPatient;
    const Eigen::Vector3d reach = (brush.radiusMm + half) * mask.geometry.spacingMm.cwiseInverse();
    const Eigen::Array3i low = (from.cwiseMin(to) - reach).array().floor().cast<int>().max(0);
    const Eigen::Array3i high =
        (from.cwiseMax(to) + reach).array().ceil().cast<int>().min(mask.geometry.size.array() - 1);
    for (int k = low.z(); k <= high.z(); ++k) {
        for (int j = low.y(); j <= high.y(); ++j) {
            for (int i = low.x(); i <= high.x(); ++i) {
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

bool isSameGrid(const VolumeGeometry& a, const VolumeGeometry& b)
{
    return a.size == b.size && a.originInPatient == b.originInPatient && a.spacingMm == b.spacingMm &&
           a.direction == b.direction;
}

std::size_t MaskChange::voxelCount() const
{
    std::size_t count = 0;
    for (const Run& run : runs) {
        count += run.count;
    }
    return count;
}

MaskChange changeOf(VoxelPlaces voxels)
{
    std::ranges::sort(voxels);
    const auto twice = std::ranges::unique(voxels);
    voxels.erase(twice.begin(), twice.end());
    MaskChange change;
    for (const std::uint32_t voxel : voxels) {
        if (!change.runs.empty() && change.runs.back().first + change.runs.back().count == voxel) {
            ++change.runs.back().count;
        } else {
            change.runs.push_back({voxel, 1});
        }
    }
    return change;
}

void flip(VoxelMask& mask, const MaskChange& change)
{
    for (const MaskChange::Run& run : change.runs) {
        const auto first = mask.voxels.begin() + run.first;
        std::transform(first, first + run.count, first,
                       [](std::uint8_t voxel) { return static_cast<std::uint8_t>(voxel == 0 ? 1 : 0); });
    }
}

TouchedBox boxOf(const VolumeGeometry& geometry, const MaskChange& change)
{
    Eigen::Vector3i low = Eigen::Vector3i::Constant(std::numeric_limits<int>::max());
    Eigen::Vector3i high = Eigen::Vector3i::Constant(-1);
    for (const MaskChange::Run& run : change.runs) {
        const Eigen::Vector3i first = geometry.voxelAt(run.first);
        const Eigen::Vector3i last = geometry.voxelAt(run.first + run.count - 1);
        low = low.cwiseMin(first).cwiseMin(last);
        high = high.cwiseMax(first).cwiseMax(last);
        if (first.y() != last.y() || first.z() != last.z()) {   // around the end of a row
            low.x() = 0;
            high.x() = geometry.size.x() - 1;
        }
        if (first.z() != last.z()) {
            low.y() = 0;
            high.y() = geometry.size.y() - 1;
        }
    }
    TouchedBox box{Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()),
                   Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity())};
    const Eigen::Affine3d patientFromVoxel = geometry.patientFromVoxel();
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d at((corner & 1) != 0 ? high.x() + 0.5 : low.x() - 0.5,
                                 (corner & 2) != 0 ? high.y() + 0.5 : low.y() - 0.5,
                                 (corner & 4) != 0 ? high.z() + 0.5 : low.z() - 0.5);
        const Eigen::Vector3d point = patientFromVoxel * at;
        box.lowInPatient = box.lowInPatient.cwiseMin(point);
        box.highInPatient = box.highInPatient.cwiseMax(point);
    }
    return box;
}

VoxelPlaces brushedInSlice(const VoxelMask& mask, const SliceGrid& slice, const MaskBrush& brush, const BrushStep& step)
{
    const Eigen::Vector2d from = slice.pixelOf(step.fromInPatient);
    const Eigen::Vector2d to = slice.pixelOf(step.toInPatient);
    const Eigen::Vector2d reach(brush.radiusMm / slice.columnStep.norm(), brush.radiusMm / slice.rowStep.norm());
    const Eigen::Array2i low = (from.cwiseMin(to) - reach).array().floor().cast<int>().max(0);
    const Eigen::Array2i high =
        (from.cwiseMax(to) + reach).array().ceil().cast<int>().min(Eigen::Array2i(slice.width - 1, slice.height - 1));
    const Eigen::Affine3d voxelFromPatient = mask.geometry.patientFromVoxel().inverse();
    Collector collector(mask, brush);
    for (int row = low.y(); row <= high.y(); ++row) {
        for (int column = low.x(); column <= high.x(); ++column) {
            const Eigen::Vector3d point = slice.pointAt({column, row});
            const Eigen::Vector3i voxel = (voxelFromPatient * point).array().round().cast<int>();
            if (distanceToStep(step, point) <= brush.radiusMm && mask.geometry.contains(voxel)) {
                collector.take(voxel, point);
            }
        }
    }
    takeBetween(mask, slice, brush, step, collector);
    return std::move(collector.found);
}

VoxelPlaces brushedInSpace(const VoxelMask& mask, const MaskBrush& brush, const BrushStep& step)
{
    const Eigen::Affine3d patientFromVoxel = mask.geometry.patientFromVoxel();
    const Eigen::Affine3d voxelFromPatient = patientFromVoxel.inverse();
    const Eigen::Vector3d from = voxelFromPatient * step.fromInPatient;
    const Eigen::Vector3d to = voxelFromPatient * step.toInPatient;
    const Eigen::Vector3d reach = brush.radiusMm * mask.geometry.spacingMm.cwiseInverse();
    const Eigen::Array3i low = (from.cwiseMin(to) - reach).array().floor().cast<int>().max(0);
    const Eigen::Array3i high =
        (from.cwiseMax(to) + reach).array().ceil().cast<int>().min(mask.geometry.size.array() - 1);
    const Eigen::Vector3d along = patientFromVoxel.linear().col(0);
    Collector collector(mask, brush);
    for (int k = low.z(); k <= high.z(); ++k) {
        for (int j = low.y(); j <= high.y(); ++j) {
            const Eigen::Vector3d start = patientFromVoxel * Eigen::Vector3d(0, j, k);
            const RowRange range = rangeInCapsule(step, brush.radiusMm, start, along, mask.geometry.size.x());
            for (int i = range.first; i <= range.last; ++i) {
                collector.take({i, j, k}, start + i * along);
            }
        }
    }
    return std::move(collector.found);
}

VoxelPlaces cutVoxels(const VoxelMask& mask, const MaskCut& cut)
{
    const Sides sides(cut);
    return cut.halfDepthMm > 0.0 ? cutInDepth(mask, cut, sides, cut.halfDepthMm) : cutInSlice(mask, cut, sides);
}

}   // namespace angiopose::core
