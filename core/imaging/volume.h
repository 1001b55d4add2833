#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Geometry of the voxels in the patient. Voxel indices are continuous; (0, 0, 0) is the center of the first voxel.
struct VolumeGeometry {
    Eigen::Vector3i size = Eigen::Vector3i::Zero();   ///< voxels along i, j, k
    Eigen::Vector3d spacingMm = Eigen::Vector3d::Ones();
    Eigen::Vector3d originInPatient = Eigen::Vector3d::Zero();   ///< center of voxel (0, 0, 0), LPS mm
    Eigen::Matrix3d direction =
        Eigen::Matrix3d::Identity();   ///< columns: unit patient directions of i, j, k; any handedness

    std::size_t voxelCount() const
    {
        return static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()) *
               static_cast<std::size_t>(size.z());
    }
    bool contains(const Eigen::Vector3i& voxel) const
    {
        return (voxel.array() >= 0).all() && (voxel.array() < size.array()).all();
    }
    std::size_t index(int i, int j, int k) const
    {
        return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size.y()) + static_cast<std::size_t>(j)) *
                   static_cast<std::size_t>(size.x()) +
               static_cast<std::size_t>(i);
    }
    /// Returns the voxel indices (i, j, k) for this linear index.
    Eigen::Vector3i voxelAt(std::size_t index) const
    {
        const auto columns = static_cast<std::size_t>(size.x());
        const auto rows = static_cast<std::size_t>(size.y());
        const std::size_t row = index / columns;
        return {static_cast<int>(index % columns), static_cast<int>(row % rows), static_cast<int>(row / rows)};
    }
    Eigen::Affine3d patientFromVoxel() const
    {
        Eigen::Affine3d map = Eigen::Affine3d::Identity();
        map.linear() = direction * spacingMm.asDiagonal();
        map.translation() = originInPatient;
        return map;
    }
};

/// Voxels of one type in storage order: i varies fastest, then j, then k.
template <class T>
struct VoxelGrid {
    VolumeGeometry geometry;
    std::vector<T> voxels;

    VoxelGrid() = default;
    explicit VoxelGrid(const VolumeGeometry& where, T fill = T{}) : geometry(where), voxels(where.voxelCount(), fill) {}

    T& at(int i, int j, int k) { return voxels[geometry.index(i, j, k)]; }
    const T& at(int i, int j, int k) const { return voxels[geometry.index(i, j, k)]; }
};

using VoxelMask = VoxelGrid<std::uint8_t>;   ///< 0 outside, nonzero inside
using LabelVolume = VoxelGrid<std::uint16_t>;   ///< 0 is background, other values are labels

/// A CT (or other) volume as stored, in 16 bit to limit the memory of large scans: value = voxel · slope + intercept.
struct Volume : VoxelGrid<std::int16_t> {
    using VoxelGrid::VoxelGrid;
    double slope = 1.0;
    double intercept = 0.0;

    /// Returns the value of a voxel, in Hounsfield units for CT.
    double value(std::size_t voxel) const { return slope * voxels[voxel] + intercept; }
};

}   // namespace angiopose::core
