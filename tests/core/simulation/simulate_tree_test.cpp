#include "core/simulation/simulated_case.h"

#include <gtest/gtest.h>
#include <queue>
#include <set>

using namespace angiopose;

namespace {

using namespace core;

bool sameBits(const VesselTree& a, const VesselTree& b)
{
    return std::equal(a.branches.begin(), a.branches.end(), b.branches.begin(), b.branches.end(),
                      [](const VesselBranch& x, const VesselBranch& y) {
                          return x.id == y.id && x.name == y.name && x.pointsInPatient == y.pointsInPatient &&
                                 x.radiusMm == y.radiusMm;
                      });
}

/// Branches reachable from the first one through shared nodes.
std::size_t connectedBranchCount(const VesselTree& tree)
{
    const std::vector<VesselNode> nodes = findNodes(tree);
    std::set<int> reached{tree.branches.front().id};
    std::queue<int> open({tree.branches.front().id});
    while (!open.empty()) {
        const int branch = open.front();
        open.pop();
        for (const VesselNode& node : nodes) {
            if (std::find(node.branchIds.begin(), node.branchIds.end(), branch) == node.branchIds.end()) {
                continue;
            }
            for (const int neighbor : node.branchIds) {
                if (reached.insert(neighbor).second) {
                    open.push(neighbor);
                }
            }
        }
    }
    return reached.size();
}

TEST(SimulateTree, SameSeedSameBitsOtherSeedOtherTree)
{
    EXPECT_TRUE(sameBits(simulateTree(7), simulateTree(7)));
    EXPECT_FALSE(sameBits(simulateTree(7), simulateTree(8)));
}

TEST(SimulateTree, IsAValidConnectedTreeOfTheAskedSize)
{
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const VesselTree tree = simulateTree(seed);
        EXPECT_FALSE(findProblem(tree)) << seed;
        EXPECT_EQ(tree.branches.size(), 24u) << seed;
        EXPECT_EQ(connectedBranchCount(tree), tree.branches.size()) << seed;
        EXPECT_NEAR(static_cast<double>(tree.pointCount()), 2000.0, 500.0) << seed;
        Eigen::AlignedBox3d box;
        for (const VesselBranch& branch : tree.branches) {
            EXPECT_GT(branch.lengthMm(), 10.0) << seed << " " << branch.name;
            for (const Eigen::Vector3d& point : branch.pointsInPatient) {
                box.extend(point);
            }
        }
        EXPECT_NEAR(box.sizes().maxCoeff(), 180.0, 1.0) << seed;
        EXPECT_GT(box.sizes().minCoeff(), 60.0) << seed;
    }
}

TEST(SimulateTree, IsSmoothAndEvenlySampled)
{
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        for (const VesselBranch& branch : simulateTree(seed).branches) {
            const auto& p = branch.pointsInPatient;
            for (std::size_t i = 1; i + 1 < p.size(); ++i) {
                const Eigen::Vector3d before = p[i] - p[i - 1];
                const Eigen::Vector3d after = p[i + 1] - p[i];
                EXPECT_NEAR(before.norm(), 1.0, 0.06) << seed << " " << branch.name;
                const double deformation = std::acos(std::min(1.0, before.normalized().dot(after.normalized())));
                EXPECT_LT(deformation / before.norm(), 1.0 / 3.0) << seed << " " << branch.name << " point " << i;
            }
        }
    }
}

TEST(SimulateTree, ChildrenAreThinnerThanTheirParentAndNothingIsThickerThanTheRoot)
{
    const VesselTree tree = simulateTree(3);
    EXPECT_NEAR(tree.branches.front().radiusMm.front(), 3.0, 1e-9);
    for (const VesselBranch& branch : tree.branches) {
        EXPECT_GE(branch.radiusMm.front(), branch.radiusMm.back()) << branch.name;
        for (const double radius : branch.radiusMm) {
            EXPECT_GT(radius, 0.2) << branch.name;
            EXPECT_LE(radius, 3.0 + 1e-9) << branch.name;
        }
    }
}

TEST(SimulateTree, SpacingBranchesAndExtentFollowTheOptions)
{
    const VesselTree tree = simulateTree(5, {.branchCount = 6, .extentMm = 90.0, .pointSpacingMm = 0.5});
    EXPECT_EQ(tree.branches.size(), 6u);
    const auto& trunk = tree.branches.front().pointsInPatient;
    EXPECT_NEAR((trunk[1] - trunk[0]).norm(), 0.5, 0.03);
    EXPECT_EQ(connectedBranchCount(tree), 6u);
}

TEST(SimulateTree, AnySizeGrowsAllItsBranches)
{
    EXPECT_EQ(simulateTree(1, {.branchCount = 1}).branches.size(), 1u);
    EXPECT_EQ(simulateTree(1, {.branchCount = 60}).branches.size(), 60u);
    EXPECT_EQ(simulateTree(1, {.extentMm = 40.0, .rootRadiusMm = 1.5}).branches.size(), 24u);
}

}   // namespace
