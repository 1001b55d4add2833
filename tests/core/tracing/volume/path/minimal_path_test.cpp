#include "core/tracing/volume/path/minimal_path.h"

#include "core/support/random.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <queue>

using namespace angiopose;

namespace {

using namespace core;

constexpr std::size_t plenty = 1'000'000;
constexpr double infinite = std::numeric_limits<double>::infinity();

VolumeGeometry cheapGrid()
{
    VolumeGeometry grid;
    grid.size = {30, 24, 20};
    grid.spacingMm = {0.5, 0.5, 0.8};
    return grid;
}

/// Random costs of 1 to 40 per mm for each voxel.
std::vector<double> drawnCosts(const VolumeGeometry& grid, std::uint64_t seed)
{
    CounterRandom random(seed);
    std::vector<double> costs(grid.voxelCount());
    for (double& cost : costs) {
        cost = 1.0 + 39.0 * std::pow(random.uniform(0.0, 1.0), 2.0);
    }
    return costs;
}

double costOfWay(const VolumeGeometry& grid, const std::vector<double>& costs, const std::vector<Eigen::Vector3i>& way)
{
    const auto at = [&](const Eigen::Vector3i& voxel) { return costs[grid.index(voxel.x(), voxel.y(), voxel.z())]; };
    double sum = 0.0;
    for (std::size_t n = 1; n < way.size(); ++n) {
        const Eigen::Vector3i step = way[n] - way[n - 1];
        EXPECT_EQ(step.cwiseAbs().maxCoeff(), 1);
        sum += 0.5 * (at(way[n]) + at(way[n - 1])) * step.cast<double>().cwiseProduct(grid.spacingMm).norm();
    }
    return sum;
}

/// Minimum cost, computed by relaxing every step until no cost decreases.
double minCost(const VolumeGeometry& grid, const std::vector<double>& costs, const Eigen::Vector3i& from,
               const Eigen::Vector3i& to)
{
    std::vector<double> known(grid.voxelCount(), infinite);
    std::queue<Eigen::Vector3i> changed;
    const auto index = [&](const Eigen::Vector3i& voxel) { return grid.index(voxel.x(), voxel.y(), voxel.z()); };
    known[index(from)] = 0.0;
    changed.push(from);
    while (!changed.empty()) {
        const Eigen::Vector3i here = changed.front();
        changed.pop();
        for (int n = 0; n < 27; ++n) {
            const Eigen::Vector3i step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
            const Eigen::Vector3i there = here + step;
            if (!grid.contains(there)) {
                continue;
            }
            const double cost = known[index(here)] + 0.5 * (costs[index(here)] + costs[index(there)]) *
                                                         step.cast<double>().cwiseProduct(grid.spacingMm).norm();
            if (cost < known[index(there)]) {
                known[index(there)] = cost;
                changed.push(there);
            }
        }
    }
    return known[index(to)];
}

VoxelCost voxelCost(const VolumeGeometry& grid, const std::vector<double>& costs, std::size_t* asked = nullptr)
{
    return {[&grid, &costs, asked](const Eigen::Vector3i& voxel) {
                if (asked != nullptr) {
                    ++*asked;
                }
                return costs[grid.index(voxel.x(), voxel.y(), voxel.z())];
            },
            1.0};
}

TEST(MinimalPath, IsTheCheapestWay)
{
    const VolumeGeometry grid = cheapGrid();
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const std::vector<double> costs = drawnCosts(grid, seed);
        const Eigen::Vector3i from(2, 3, 4);
        const Eigen::Vector3i to(27, 20, 15);
        TracingProgress progress({});
        const auto way = findMinimalPath(grid, from, to, voxelCost(grid, costs), plenty, progress).voxels;
        ASSERT_FALSE(way.empty());
        EXPECT_EQ(way.front(), from);
        EXPECT_EQ(way.back(), to);
        EXPECT_NEAR(costOfWay(grid, costs, way), minCost(grid, costs, from, to), 1e-3) << "seed " << seed;
    }
}

TEST(MinimalPath, SearchesLittleBesideAStraightVessel)
{
    const VolumeGeometry grid = cheapGrid();
    std::vector<double> costs(grid.voxelCount(), 5.7);   // a chamber
    for (int i = 0; i < grid.size.x(); ++i) {
        costs[grid.index(i, 12, 10)] = 1.0;
    }
    std::size_t asked = 0;
    TracingProgress progress({});
    const auto way =
        findMinimalPath(grid, {1, 12, 10}, {28, 12, 10}, voxelCost(grid, costs, &asked), plenty, progress).voxels;
    EXPECT_EQ(way.size(), 28U);
    EXPECT_LT(asked, 400U);   // the vessel and its neighboring voxels; an uninformed search would take thousands
}

TEST(MinimalPath, KeepsOutOfWhatIsClosed)
{
    const VolumeGeometry grid = cheapGrid();
    std::vector<double> costs(grid.voxelCount(), 1.0);
    for (int k = 0; k < grid.size.z(); ++k) {
        for (int j = 0; j < grid.size.y(); ++j) {
            costs[grid.index(15, j, k)] = j == 3 && k == 3 ? 1.0 : infinite;   // a wall with a gap
        }
    }
    TracingProgress progress({});
    const auto way = findMinimalPath(grid, {2, 20, 15}, {28, 20, 15}, voxelCost(grid, costs), plenty, progress).voxels;
    ASSERT_FALSE(way.empty());
    EXPECT_NE(std::ranges::find(way, Eigen::Vector3i(15, 3, 3)), way.end());
    costs[grid.index(15, 3, 3)] = infinite;
    const MinimalPath none = findMinimalPath(grid, {2, 20, 15}, {28, 20, 15}, voxelCost(grid, costs), plenty, progress);
    EXPECT_TRUE(none.voxels.empty());
    EXPECT_FALSE(none.isTruncated);
    EXPECT_TRUE(findMinimalPath(grid, {2, 20, 15}, {28, 20, 15}, voxelCost(grid, costs), 10, progress).isTruncated);
}

}   // namespace
