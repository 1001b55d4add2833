#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"
#include "tests/support/for_each.h"

#include <algorithm>
#include <cmath>

namespace angiopose::test {

/// Distance (mm) to the axis of a vessel that runs up from (0, 0, 0) and bifurcates at z = 40, up to z = 80.
inline double distanceToFork(const Eigen::Vector3d& point)
{
    const auto toSegment = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        const double t = std::clamp((point - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
        return (point - from - t * (to - from)).norm();
    };
    const Eigen::Vector3d fork(0, 0, 40);
    return std::min({toSegment({0, 0, 0}, fork), toSegment(fork, {-20, 0, 80}), toSegment(fork, {20, 5, 80})});
}

inline core::VolumeGeometry forkGeometry()
{
    core::VolumeGeometry geometry;
    geometry.size = {64, 40, 96};
    geometry.originInPatient = {-32, -18, -6};
    return geometry;
}

/// The bifurcating vessel of radius 4 mm as label 2 in an image with another object, label 7.
inline core::LabelVolume forkLabels()
{
    core::LabelVolume labels(forkGeometry());
    test::forEachVoxel(labels.geometry.size, [&](int i, int j, int k) {
        const Eigen::Vector3d point = labels.geometry.patientFromVoxel() * Eigen::Vector3d(i, j, k);
        labels.at(i, j, k) = distanceToFork(point) < 4.0 ? 2 : (j > 34 ? 7 : 0);
    });
    return labels;
}

/// A CT angiogram of the bifurcating vessel: blood of 350 HU in tissue of 40 HU, surrounded by air, with some noise.
inline core::Volume forkScan()
{
    core::Volume scan(forkGeometry());
    unsigned state = 1;
    test::forEachVoxel(scan.geometry.size, [&](int i, int j, int k) {
        state = state * 1664525U + 1013904223U;
        const double noise = static_cast<double>(state >> 16 & 31U) - 15.0;
        const Eigen::Vector3d point = scan.geometry.patientFromVoxel() * Eigen::Vector3d(i, j, k);
        const double inside = std::clamp(4.5 - distanceToFork(point), 0.0, 1.0);
        const bool isAir = j < 3 || j > 36;
        scan.at(i, j, k) = static_cast<std::int16_t>(isAir ? -1000 : 40 + 310 * inside + noise);
    });
    return scan;
}

/// Number of free ends of a tree; the bifurcating vessel has three, however its branches are cut.
inline long endsOf(const core::VesselTree& tree)
{
    const auto nodes = core::findNodes(tree);
    return std::count_if(nodes.begin(), nodes.end(), [](const auto& node) { return !node.isBifurcation(); });
}

}   // namespace angiopose::test
