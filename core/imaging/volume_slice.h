#pragma once

#include "core/imaging/volume.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace angiopose::core {

enum class BodyPlane { Axial, Coronal, Sagittal };

inline constexpr std::array bodyPlanes{BodyPlane::Axial, BodyPlane::Coronal, BodyPlane::Sagittal};

/// How a plane is looked at: axial from the feet, coronal from the front, sagittal from the left (patient LPS).
struct PlaneAxes {
    Eigen::Vector3d right;
    Eigen::Vector3d down;
    Eigen::Vector3d normal;   ///< a positive axis of the patient: left, back or head
};
PlaneAxes axesOf(BodyPlane plane);

/// Pixels of a slice through the patient, LPS mm. Pixel indices are continuous; (0, 0) is the centre of the first.
struct SliceGrid {
    int width = 0;
    int height = 0;
    Eigen::Vector3d firstInPatient = Eigen::Vector3d::Zero();   ///< centre of pixel (0, 0)
    Eigen::Vector3d columnStep = Eigen::Vector3d::UnitX();   ///< to the pixel on the right
    Eigen::Vector3d rowStep = Eigen::Vector3d::UnitY();   ///< to the pixel below
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double thicknessMm = 1.0;   ///< to the next slice

    Eigen::Vector3d pointAt(const Eigen::Vector2d& pixel) const
    {
        return firstInPatient + pixel.x() * columnStep + pixel.y() * rowStep;
    }
    Eigen::Vector2d pixelOf(const Eigen::Vector3d& pointInPatient) const
    {
        const Eigen::Vector3d way = pointInPatient - firstInPatient;
        return {way.dot(columnStep) / columnStep.squaredNorm(), way.dot(rowStep) / rowStep.squaredNorm()};
    }
    /// How far a point lies before the slice, along the normal.
    double distanceMm(const Eigen::Vector3d& pointInPatient) const
    {
        return (pointInPatient - firstInPatient).dot(normal);
    }
    bool operator==(const SliceGrid&) const = default;
};

/// The slice of a volume through a point, over the whole volume. Where the volume's axes are the patient's in some
/// order, it is the nearest stored slice, pixel for pixel; an oblique volume is cut along the patient's axes, with its
/// finest spacing.
SliceGrid sliceThrough(const VolumeGeometry& geometry, BodyPlane plane, const Eigen::Vector3d& pointInPatient);

/// Number of slices of a plane, and which one goes through a point, counted along the normal from 0.
int sliceCount(const VolumeGeometry& geometry, BodyPlane plane);
int sliceIndex(const VolumeGeometry& geometry, BodyPlane plane, const Eigen::Vector3d& pointInPatient);

/// Values at the pixels of a slice, linearly interpolated where these lie between voxels; NaN outside the volume.
std::vector<float> sliceValues(const Volume& volume, const SliceGrid& grid);

/// The mask as it is at the pixels of a slice, by the nearest voxel; 0 outside.
std::vector<std::uint8_t> sliceMask(const VoxelMask& mask, const SliceGrid& grid);

/// Value of the voxel that a point lies in; nothing outside.
std::optional<double> valueAt(const Volume& volume, const Eigen::Vector3d& pointInPatient);

/// The nearest point of the box of voxel centres, in patient axes.
Eigen::Vector3d clampedTo(const VolumeGeometry& geometry, const Eigen::Vector3d& pointInPatient);
Eigen::Vector3d centerOf(const VolumeGeometry& geometry);

}   // namespace angiopose::core