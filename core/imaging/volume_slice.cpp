#include "core/imaging/volume_slice.h"

#include "core/support/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr int maxSliceSidePx = 4096;
constexpr double voxelTolerance = 0.2;   // distance from voxel centers at which rounding stays in the voxel

/// Extent of the voxel centers along the patient's axes, and the finest useful spacing of slices.
struct PatientBox {
    Eigen::Vector3d lowMm;
    Eigen::Vector3d highMm;
    Eigen::Vector3d stepMm;
    bool isAligned = false;   ///< whether the volume's axes are parallel to the patient's axes, in any order
};

PatientBox boxOf(const VolumeGeometry& geometry)
{
    PatientBox box;
    const Eigen::Vector3d last = (geometry.size.array() - 1).max(0).cast<double>();
    const Eigen::Matrix3d steps = geometry.direction * geometry.spacingMm.asDiagonal();
    const Eigen::Matrix3d edges = steps * last.asDiagonal();
    box.lowMm = geometry.originInPatient + edges.cwiseMin(0.0).rowwise().sum();
    box.highMm = geometry.originInPatient + edges.cwiseMax(0.0).rowwise().sum();
    box.isAligned = true;
    for (int axis = 0; axis < 3; ++axis) {
        Eigen::Index along = 0;
        geometry.direction.col(axis).cwiseAbs().maxCoeff(&along);
        box.stepMm[along] = std::abs(steps(along, axis));
        Eigen::Vector3d across = edges.col(axis);
        across[along] = 0.0;
        box.isAligned = box.isAligned && across.norm() < voxelTolerance * geometry.spacingMm.minCoeff();
    }
    if (!box.isAligned) {
        box.stepMm.setConstant(geometry.spacingMm.minCoeff());
    }
    return box;
}

Eigen::Index normalAxis(BodyPlane plane)
{
    return plane == BodyPlane::Axial ? 2 : plane == BodyPlane::Coronal ? 1 : 0;
}

int stepsAlong(const PatientBox& box, Eigen::Index axis)
{
    return static_cast<int>(std::lround((box.highMm[axis] - box.lowMm[axis]) / box.stepMm[axis]));
}

int nearestStep(const PatientBox& box, Eigen::Index axis, double positionMm)
{
    const double steps = std::round((positionMm - box.lowMm[axis]) / box.stepMm[axis]);
    return static_cast<int>(std::clamp(steps, 0.0, static_cast<double>(stepsAlong(box, axis))));
}

/// A pixel grid in continuous voxel indices.
struct SliceInVoxels {
    Eigen::Vector3d first;
    Eigen::Vector3d columnStep;
    Eigen::Vector3d rowStep;

    Eigen::Vector3d at(int column, int row) const { return first + column * columnStep + row * rowStep; }
};

SliceInVoxels sliceInVoxels(const VolumeGeometry& geometry, const SliceGrid& grid)
{
    const Eigen::Affine3d voxelFromPatient = geometry.patientFromVoxel().inverse();
    return {voxelFromPatient * grid.firstInPatient, voxelFromPatient.linear() * grid.columnStep,
            voxelFromPatient.linear() * grid.rowStep};
}

bool isWhole(const Eigen::Vector3d& value, double tolerance)
{
    return (value - value.array().round().matrix()).cwiseAbs().maxCoeff() < tolerance;
}

/// Whether every pixel coincides with the center of a different voxel.
bool isOnVoxelCenters(const SliceInVoxels& slice, const SliceGrid& grid)
{
    return isWhole(slice.at(0, 0), voxelTolerance) && isWhole(slice.at(grid.width - 1, 0), voxelTolerance) &&
           isWhole(slice.at(0, grid.height - 1), voxelTolerance) && isWhole(slice.columnStep, voxelTolerance) &&
           isWhole(slice.rowStep, voxelTolerance);
}

Eigen::Vector3i rounded(const Eigen::Vector3d& voxel)
{
    return voxel.array().round().cast<int>();
}

/// Calls `work(row)` for every row, with bands of rows in parallel: memory latency limits the speed of slices across
/// the storage order.
template <class Work>
void forRowsInParallel(int rows, const Work& work)
{
    constexpr int bandRows = 32;
    constexpr int maxThreads = 4;
    const auto bands = static_cast<std::size_t>((rows + bandRows - 1) / bandRows);
    const auto workBand = [&](std::size_t band) {
        const int first = static_cast<int>(band) * bandRows;
        for (int row = first; row < std::min(first + bandRows, rows); ++row) {
            work(row);
        }
    };
    parallelFor(bands, std::min(maxThreads, threadCount(0)), workBand, [](double) { return true; });
}

/// Calls `take(pixel, voxel)` for every pixel that lies inside a voxel.
template <class Take>
void forNearestVoxels(const VolumeGeometry& geometry, const SliceInVoxels& slice, const SliceGrid& grid,
                      const Take& take)
{
    std::size_t pixel = 0;
    for (int row = 0; row < grid.height; ++row) {
        for (int column = 0; column < grid.width; ++column, ++pixel) {
            const Eigen::Vector3i voxel = rounded(slice.at(column, row));
            if (geometry.contains(voxel)) {
                take(pixel, geometry.index(voxel.x(), voxel.y(), voxel.z()));
            }
        }
    }
}

/// Calls `take(pixel, voxel)` for a grid on voxel centers, where the index step from pixel to pixel is constant.
template <class Take>
void forAlignedVoxels(const VolumeGeometry& geometry, const SliceInVoxels& slice, const SliceGrid& grid,
                      const Take& take)
{
    const auto stored = [&](int column, int row) {
        const Eigen::Vector3i voxel = rounded(slice.at(column, row))
                                          .cwiseMax(0)
                                          .cwiseMin(geometry.size.array().matrix() - Eigen::Vector3i::Ones());
        return static_cast<std::ptrdiff_t>(geometry.index(voxel.x(), voxel.y(), voxel.z()));
    };
    std::vector<std::ptrdiff_t> columns(static_cast<std::size_t>(grid.width));
    for (int column = 0; column < grid.width; ++column) {
        columns[static_cast<std::size_t>(column)] = stored(column, 0) - stored(0, 0);
    }
    forRowsInParallel(grid.height, [&](int row) {
        const std::ptrdiff_t start = stored(0, row);
        auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width);
        for (const std::ptrdiff_t column : columns) {
            take(pixel++, static_cast<std::size_t>(start + column));
        }
    });
}

/// Whether `sliceThrough` made the grid for this geometry.
bool isVoxelAligned(const VolumeGeometry& geometry, const SliceInVoxels& slice, const SliceGrid& grid)
{
    const auto isInside = [&](int column, int row) { return geometry.contains(rounded(slice.at(column, row))); };
    return grid.width > 0 && grid.height > 0 && isOnVoxelCenters(slice, grid) && isInside(0, 0) &&
           isInside(grid.width - 1, 0) && isInside(0, grid.height - 1) && isInside(grid.width - 1, grid.height - 1);
}

/// Returns the linearly interpolated value; NaN more than half a voxel beyond the outermost voxel centers.
float interpolateTrilinear(const Volume& volume, const Eigen::Vector3d& voxel)
{
    const VolumeGeometry& geometry = volume.geometry;
    const Eigen::Vector3d last = (geometry.size.array() - 1).cast<double>();
    if ((voxel.array() < -0.5).any() || (voxel.array() > last.array() + 0.5).any()) {
        return std::numeric_limits<float>::quiet_NaN();
    }
    const Eigen::Vector3d inside = voxel.cwiseMax(0.0).cwiseMin(last);
    const Eigen::Vector3i low = inside.array().floor().cast<int>();
    const Eigen::Vector3i high = (low.array() + 1).min(geometry.size.array() - 1);
    const Eigen::Vector3d part = inside - low.cast<double>();
    const auto along = [&](int j, int k) {
        return (1.0 - part.x()) * volume.at(low.x(), j, k) + part.x() * volume.at(high.x(), j, k);
    };
    const double near = (1.0 - part.y()) * along(low.y(), low.z()) + part.y() * along(high.y(), low.z());
    const double far = (1.0 - part.y()) * along(low.y(), high.z()) + part.y() * along(high.y(), high.z());
    return static_cast<float>(volume.slope * ((1.0 - part.z()) * near + part.z() * far) + volume.intercept);
}

}   // namespace

PlaneAxes axesOf(BodyPlane plane)
{
    switch (plane) {
        case BodyPlane::Axial:
            return {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
        case BodyPlane::Coronal:
            return {Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY()};
        default:
            return {Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX()};
    }
}

SliceGrid sliceThrough(const VolumeGeometry& geometry, BodyPlane plane, const Eigen::Vector3d& pointInPatient)
{
    const PatientBox box = boxOf(geometry);
    const PlaneAxes axes = axesOf(plane);
    const Eigen::Index normal = normalAxis(plane);
    const auto lengthOf = [&](const Eigen::Vector3d& axis) { return axis.cwiseAbs().dot(box.stepMm); };
    const auto pixelsAlong = [&](const Eigen::Vector3d& axis) {
        Eigen::Index which = 0;
        axis.cwiseAbs().maxCoeff(&which);
        return std::min(maxSliceSidePx, stepsAlong(box, which) + 1);
    };
    SliceGrid grid;
    grid.width = pixelsAlong(axes.right);
    grid.height = pixelsAlong(axes.down);
    grid.columnStep = axes.right * lengthOf(axes.right);
    grid.rowStep = axes.down * lengthOf(axes.down);
    grid.normal = axes.normal;
    grid.thicknessMm = box.stepMm[normal];
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const double sign = axes.right[axis] + axes.down[axis];
        grid.firstInPatient[axis] = sign < 0.0 ? box.highMm[axis] : box.lowMm[axis];
    }
    grid.firstInPatient[normal] =
        box.lowMm[normal] + nearestStep(box, normal, pointInPatient[normal]) * box.stepMm[normal];
    return grid;
}

int sliceCount(const VolumeGeometry& geometry, BodyPlane plane)
{
    return stepsAlong(boxOf(geometry), normalAxis(plane)) + 1;
}

int sliceIndex(const VolumeGeometry& geometry, BodyPlane plane, const Eigen::Vector3d& pointInPatient)
{
    const Eigen::Index axis = normalAxis(plane);
    return nearestStep(boxOf(geometry), axis, pointInPatient[axis]);
}

std::vector<float> sliceValues(const Volume& volume, const SliceGrid& grid)
{
    const SliceInVoxels slice = sliceInVoxels(volume.geometry, grid);
    std::vector<float> values(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height),
                              std::numeric_limits<float>::quiet_NaN());
    if (isVoxelAligned(volume.geometry, slice, grid)) {
        const auto slope = static_cast<float>(volume.slope);
        const auto intercept = static_cast<float>(volume.intercept);
        forAlignedVoxels(volume.geometry, slice, grid, [&](std::size_t pixel, std::size_t voxel) {
            values[pixel] = slope * volume.voxels[voxel] + intercept;
        });
        return values;
    }
    forRowsInParallel(grid.height, [&](int row) {
        auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width);
        for (int column = 0; column < grid.width; ++column, ++pixel) {
            values[pixel] = interpolateTrilinear(volume, slice.at(column, row));
        }
    });
    return values;
}

std::vector<std::uint8_t> sliceMask(const VoxelMask& mask, const SliceGrid& grid)
{
    const SliceInVoxels slice = sliceInVoxels(mask.geometry, grid);
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height), 0);
    const auto take = [&](std::size_t pixel, std::size_t voxel) { pixels[pixel] = mask.voxels[voxel]; };
    if (isVoxelAligned(mask.geometry, slice, grid)) {
        forAlignedVoxels(mask.geometry, slice, grid, take);
    } else {
        forNearestVoxels(mask.geometry, slice, grid, take);
    }
    return pixels;
}

std::optional<double> valueAt(const Volume& volume, const Eigen::Vector3d& pointInPatient)
{
    const Eigen::Vector3i voxel = rounded(volume.geometry.patientFromVoxel().inverse() * pointInPatient);
    if (!volume.geometry.contains(voxel)) {
        return std::nullopt;
    }
    return volume.value(volume.geometry.index(voxel.x(), voxel.y(), voxel.z()));
}

Eigen::Vector3d clampToVolume(const VolumeGeometry& geometry, const Eigen::Vector3d& pointInPatient)
{
    const PatientBox box = boxOf(geometry);
    return pointInPatient.cwiseMax(box.lowMm).cwiseMin(box.highMm);
}

Eigen::Vector3d centerOf(const VolumeGeometry& geometry)
{
    return geometry.patientFromVoxel() * (0.5 * (geometry.size.cast<double>() - Eigen::Vector3d::Ones()));
}

}   // namespace angiopose::core
