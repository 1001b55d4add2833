#pragma once

#include "core/imaging/volume.h"
#include "tests/support/for_each.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace angiopose::test {

/// One of the 48 ways to store the same voxels: axis `source[k]` of the original runs along axis k, reversed or not.
struct AxisOrder {
    std::array<int, 3> source;
    std::array<bool, 3> isReversed;
};

inline std::vector<AxisOrder> allAxisOrders()
{
    std::vector<AxisOrder> orders;
    std::array<int, 3> source = {0, 1, 2};
    do {
        for (unsigned flips = 0; flips < 8; ++flips) {
            orders.push_back({source, {(flips & 1U) != 0, (flips & 2U) != 0, (flips & 4U) != 0}});
        }
    } while (std::next_permutation(source.begin(), source.end()));
    return orders;
}

/// Voxel of the original that is stored at `voxel`.
inline Eigen::Vector3i originalVoxel(const AxisOrder& order, const Eigen::Vector3i& originalSize,
                                     const Eigen::Vector3i& voxel)
{
    Eigen::Vector3i original;
    for (int k = 0; k < 3; ++k) {
        const int axis = order.source[static_cast<std::size_t>(k)];
        original[axis] = order.isReversed[static_cast<std::size_t>(k)] ? originalSize[axis] - 1 - voxel[k] : voxel[k];
    }
    return original;
}

/// The same voxels at the same positions in the patient, stored in another axis order.
template <class Grid>
Grid stored(const Grid& original, const AxisOrder& order)
{
    const core::VolumeGeometry& from = original.geometry;
    core::VolumeGeometry geometry;
    for (int k = 0; k < 3; ++k) {
        const int axis = order.source[static_cast<std::size_t>(k)];
        geometry.size[k] = from.size[axis];
        geometry.spacingMm[k] = from.spacingMm[axis];
        geometry.direction.col(k) =
            from.direction.col(axis) * (order.isReversed[static_cast<std::size_t>(k)] ? -1.0 : 1.0);
    }
    const Eigen::Vector3i first = originalVoxel(order, from.size, Eigen::Vector3i::Zero());
    geometry.originInPatient = from.patientFromVoxel() * first.cast<double>();
    Grid result = original;
    result.geometry = geometry;
    test::forEachVoxel(geometry.size, [&](int i, int j, int k) {
        const Eigen::Vector3i at = originalVoxel(order, from.size, {i, j, k});
        result.at(i, j, k) = original.at(at.x(), at.y(), at.z());
    });
    return result;
}

/// A small oblique volume in which every voxel has a unique value.
inline core::Volume countedVolume(const Eigen::Vector3i& size = {4, 5, 6})
{
    core::VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacingMm = {0.5, 0.75, 1.25};
    geometry.originInPatient = {-31.5, 12.25, 540.75};
    geometry.direction =
        (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()))
            .toRotationMatrix();
    core::Volume volume(geometry);
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
        volume.voxels[i] = static_cast<std::int16_t>(i) - 50;
    }
    return volume;
}

/// Largest distance (mm) between the positions of equal values in two volumes; each value must occur once in both.
inline double largestDisplacement(const core::Volume& a, const core::Volume& b)
{
    if (a.voxels.size() != b.voxels.size()) {
        return 1e9;
    }
    const auto places = [](const core::Volume& volume) {
        std::vector<std::pair<double, Eigen::Vector3d>> result;
        test::forEachVoxel(volume.geometry.size, [&](int i, int j, int k) {
            result.emplace_back(volume.value(volume.geometry.index(i, j, k)),
                                volume.geometry.patientFromVoxel() * Eigen::Vector3d(i, j, k));
        });
        std::sort(result.begin(), result.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
        return result;
    };
    const auto first = places(a), second = places(b);
    double largest = 0.0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        const bool isSameValue = std::abs(first[i].first - second[i].first) < 1e-9;
        largest = std::max(largest, isSameValue ? (first[i].second - second[i].second).norm() : 1e9);
    }
    return largest;
}

}   // namespace angiopose::test
