#pragma once

#include "core/imaging/volume.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace angiopose::core {

enum class BodyPlane { Axial, Coronal, Sagittal };

inline constexpr std::array bodyPlanes{BodyPlane::Axial, BodyPlane::Coronal, BodyPlane::Sagittal};

/// Viewing direction of a plane: axial from the feet, coronal from anterior, sagittal from the left (patient LPS).
struct PlaneAxes {
    Eigen::Vector3d right;
    Eigen::Vector3d down;
    Eigen::Vector3d normal;   ///< one of the positive patient axes: left, posterior or superior
};
PlaneAxes axesOf(BodyPlane plane);

/// Pixel grid of a slice through the patient (LPS, mm). Pixel indices are continuous; (0, 0) is the first pixel center.
struct SliceGrid {
    int width = 0;
    int height = 0;
    Eigen::Vector3d firstInPatient = Eigen::Vector3d::Zero();   ///< center of pixel (0, 0)
    Eigen::Vector3d columnStep = Eigen::Vector3d::UnitX();   ///< offset to the next pixel on the right
    Eigen::Vector3d rowStep = Eigen::Vector3d::UnitY();   ///< offset to the next pixel below
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double thicknessMm = 1.0;   ///< distance to the next slice

    Eigen::Vector3d pointAt(const Eigen::Vector2d& pixel) const
    {
        return firstInPatient + pixel.x() * columnStep + pixel.y() * rowStep;
    }
    Eigen::Vector2d pixelOf(const Eigen::Vector3d& pointInPatient) const
    {
        const Eigen::Vector3d offset = pointInPatient - firstInPatient;
        return {offset.dot(columnStep) / columnStep.squaredNorm(), offset.dot(rowStep) / rowStep.squaredNorm()};
    }
    /// Returns the signed distance of a point from the slice, along the normal.
    double distanceMm(const Eigen::Vector3d& pointInPatient) const
    {
        return (pointInPatient - firstInPatient).dot(normal);
    }
    bool operator==(const SliceGrid&) const = default;
};

/// Returns the full slice of a volume through a point. If the volume's axes are the patient's in some order, this is
/// the nearest stored slice, pixel for pixel; an oblique volume is cut along the patient's axes at its finest spacing.
SliceGrid sliceThrough(const VolumeGeometry& geometry, BodyPlane plane, const Eigen::Vector3d& pointInPatient);

/// Returns the number of slices of a plane, or the index of the slice through a point, starting at 0 along the normal.
int sliceCount(const VolumeGeometry& geometry, BodyPlane plane);
int sliceIndex(const VolumeGeometry& geometry, BodyPlane plane, const Eigen::Vector3d& pointInPatient);

/// Returns the values at the pixels of a slice, linearly interpolated between voxels; NaN outside the volume.
std::vector<float> sliceValues(const Volume& volume, const SliceGrid& grid);

/// Returns the mask at the pixels of a slice, by nearest voxel; 0 outside the volume.
std::vector<std::uint8_t> sliceMask(const VoxelMask& mask, const SliceGrid& grid);

/// Returns the value of the voxel that contains a point; nullopt outside the volume.
std::optional<double> valueAt(const Volume& volume, const Eigen::Vector3d& pointInPatient);

/// Returns the nearest point inside the bounding box of the voxel centers along the patient's axes.
Eigen::Vector3d clampToVolume(const VolumeGeometry& geometry, const Eigen::Vector3d& pointInPatient);
Eigen::Vector3d centerOf(const VolumeGeometry& geometry);

}   // namespace angiopose::core
