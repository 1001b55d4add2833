#include "tests/benchmark/drawn_heart.h"

#include "core/support/random.h"
#include "io/vessel_tree_file.h"
#include "tests/support/for_each.h"
#include "tests/support/test_data.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace angiopose::benchmarks {
namespace {

/// Signed distance to the wall of the nearest vessel, negative inside; computed only near the points of the tree.
std::vector<float> wallDistances(const core::VolumeGeometry& grid, const core::VesselTree& tree)
{
    constexpr double reachMm = 2.0;
    std::vector<float> distances(grid.voxelCount(), std::numeric_limits<float>::infinity());
    const Eigen::Affine3d voxelFromPatient = grid.patientFromVoxel().inverse();
    for (const core::VesselBranch& branch : core::resampled(tree, 0.3).branches) {
        for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
            const double radiusMm = branch.radiusMm[n];
            const Eigen::Vector3d voxel = voxelFromPatient * branch.pointsInPatient[n];
            const Eigen::Vector3d half = (radiusMm + reachMm) * grid.spacingMm.cwiseInverse();
            const Eigen::Vector3i low = (voxel - half).array().floor().cast<int>().max(0);
            const Eigen::Vector3i high = (voxel + half).array().ceil().cast<int>().min(grid.size.array() - 1);
            test::forEachVoxel(low, high + Eigen::Vector3i::Ones(), [&](int i, int j, int k) {
                const double away = (Eigen::Vector3d(i, j, k) - voxel).cwiseProduct(grid.spacingMm).norm() - radiusMm;
                float& kept = distances[grid.index(i, j, k)];
                kept = std::min(kept, static_cast<float>(away));
            });
        }
    }
    return distances;
}

}   // namespace

core::VesselTree coronaryTree(const std::string& side)
{
    auto read = io::readVesselTree(test::dataFile("coronary-ccta-centerlines/" + side + "_cl.vtp").string());
    if (!read) {
        std::printf("%s\n", read.error().message.text().c_str());
        return {};
    }
    return std::move(read).value();
}

core::Volume drawnHeart(const core::VesselTree& tree, double bloodHu)
{
    Eigen::AlignedBox3d box;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            box.extend(point);
        }
    }
    core::VolumeGeometry grid;
    grid.spacingMm = Eigen::Vector3d(0.4, 0.4, 0.5);
    grid.originInPatient = box.min() - Eigen::Vector3d::Constant(12.0);
    grid.size = ((box.sizes().array() + 24.0) / grid.spacingMm.array()).ceil().cast<int>();
    const std::vector<float> walls = wallDistances(grid, tree);
    const Eigen::Vector3d middle = core::centroidInPatient(tree);
    double chamberMm = std::numeric_limits<double>::infinity();
    for (const core::VesselBranch& branch : tree.branches) {
        for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
            chamberMm = std::min(chamberMm, (branch.pointsInPatient[n] - middle).norm() - branch.radiusMm[n] - 2.0);
        }
    }
    core::Volume heart(grid);
    core::CounterRandom random(7);
    for (std::size_t n = 0; n < heart.voxels.size(); ++n) {
        const Eigen::Vector3d place = grid.patientFromVoxel() * grid.voxelAt(n).cast<double>();
        const double toChamber = (place - middle).norm() - chamberMm;
        const double tissue = toChamber < 4.0 ? 110.0 : -60.0;   // muscle, fat
        const double depth = -std::min(static_cast<double>(walls[n]), toChamber);
        const double share = std::clamp(0.5 + depth / 0.8, 0.0, 1.0);
        heart.voxels[n] =
            static_cast<std::int16_t>(std::lround(tissue + share * (bloodHu - tissue) + 30.0 * random.normal()));
    }
    return heart;
}

}   // namespace angiopose::benchmarks
