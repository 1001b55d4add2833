#include "core/vessel/vessel_tree.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

/// A trunk along x that splits at (10, 0, 0) into two branches.
VesselTree forkedTree()
{
    VesselTree tree;
    tree.branches.push_back({1, "trunk", {{0, 0, 0}, {5, 0, 0}, {10, 0, 0}}, {3, 3, 2}});
    tree.branches.push_back({2, "left", {{10.2, 0, 0}, {10, 8, 0}}, {}});
    tree.branches.push_back({3, "right", {{10, -0.3, 0}, {10, -4, 0}}, {}});
    return tree;
}

TEST(VesselTree, NodesJoinBranchesThatTouch)
{
    const auto nodes = findNodes(forkedTree());
    ASSERT_EQ(nodes.size(), 4u);
    int bifurcations = 0;
    for (const VesselNode& node : nodes) {
        if (node.isBifurcation()) {
            ++bifurcations;
            EXPECT_EQ(node.branchIds.size(), 3u);
        }
    }
    EXPECT_EQ(bifurcations, 1);
}

TEST(VesselTree, ABranchLeavingMidwayMakesABifurcation)
{
    VesselTree tree;
    tree.branches.push_back({1, "", {{0, 0, 0}, {5, 0, 0}, {10, 0, 0}}, {}});
    tree.branches.push_back({2, "", {{5, 0, 0}, {5, 9, 0}}, {}});
    const auto nodes = findNodes(tree);
    EXPECT_EQ(nodes.size(), 4u);
}

TEST(VesselTree, CompactIsWhatIsHardlyLongerThanWide)
{
    EXPECT_FALSE(isCompact(forkedTree()));
    VesselTree ball;
    ball.branches.push_back({1, "", {{0, 0, 0}, {0, 0, 23}}, {2, 12}});
    EXPECT_TRUE(isCompact(ball));
    ball.branches.push_back({2, "", {{0, 0, 23}, {0, 0, 60}}, {}});
    EXPECT_FALSE(isCompact(ball)) << "all branches count";
    ball.branches.resize(1);
    ball.branches.front().radiusMm.clear();
    EXPECT_FALSE(isCompact(ball)) << "widths unknown";
}

TEST(VesselTree, CentroidWeighsByLengthNotByPoints)
{
    VesselTree tree;
    tree.branches.push_back({1, "", {{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}, {10, 0, 0}}, {}});
    EXPECT_TRUE(centroidInPatient(tree).isApprox(Eigen::Vector3d(5, 0, 0), 1e-12));
}

TEST(VesselTree, ResamplingIsEvenAndKeepsEndsAndRadii)
{
    const VesselTree even = resampled(forkedTree(), 1.0);
    const VesselBranch& trunk = even.branches.front();
    ASSERT_EQ(trunk.pointsInPatient.size(), 11u);
    EXPECT_TRUE(trunk.pointsInPatient.front().isApprox(Eigen::Vector3d(0, 0, 0)));
    EXPECT_TRUE(trunk.pointsInPatient.back().isApprox(Eigen::Vector3d(10, 0, 0)));
    for (std::size_t i = 1; i < trunk.pointsInPatient.size(); ++i) {
        EXPECT_NEAR((trunk.pointsInPatient[i] - trunk.pointsInPatient[i - 1]).norm(), 1.0, 1e-12);
    }
    EXPECT_NEAR(trunk.radiusMm[8], 2.4, 1e-12);
    EXPECT_TRUE(even.branches[1].radiusMm.empty());
}

TEST(VesselTree, ProblemsAreNamed)
{
    EXPECT_FALSE(findProblem(forkedTree()));
    EXPECT_TRUE(findProblem(VesselTree{}));
    VesselTree nan = forkedTree();
    nan.branches[1].pointsInPatient[0].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(findProblem(nan)->text().find("Branch 2"), std::string::npos);
    VesselTree twice = forkedTree();
    twice.branches[1].id = 1;
    EXPECT_NE(findProblem(twice)->text().find("twice"), std::string::npos);
    VesselTree onePoint = forkedTree();
    onePoint.branches[0].pointsInPatient.resize(1);
    EXPECT_TRUE(findProblem(onePoint));
    VesselTree flat = forkedTree();
    flat.branches[1].pointsInPatient = {{1, 1, 1}, {1, 1, 1}};
    EXPECT_NE(findProblem(flat)->text().find("length"), std::string::npos);
}

TEST(VesselTree, ExcludedBranchesAreGone)
{
    const VesselTree rest = withoutBranches(forkedTree(), {2});
    EXPECT_EQ(rest.branches.size(), 2u);
    EXPECT_EQ(rest.find(2), nullptr);
}

/// A branch of two points along x.
core::VesselTree stretch(double length, double radius)
{
    core::VesselBranch branch;
    branch.id = 1;
    branch.pointsInPatient = {{0.0, 0.0, 0.0}, {length, 0.0, 0.0}};
    branch.radiusMm = {radius, radius};
    return {{branch}};
}

TEST(VesselTree, DoubtsLengthsAndWidthsThatNoVesselsHave)
{
    EXPECT_DOUBLE_EQ(core::extentMm(stretch(120.0, 1.5)), 120.0);
    EXPECT_TRUE(core::isPlausibleSize(stretch(120.0, 1.5)));
    EXPECT_FALSE(core::isPlausibleSize(stretch(0.12, 0.0015))) << "metres";
    EXPECT_FALSE(core::isPlausibleSize(stretch(12.0, 0.1))) << "centimeters, recognized by the width alone";
    EXPECT_FALSE(core::isPlausibleSize(stretch(120000.0, 1500.0))) << "micrometres";
    core::VesselTree bare = stretch(120.0, 1.5);
    bare.branches[0].radiusMm.clear();
    EXPECT_TRUE(core::isPlausibleSize(bare));
}

}   // namespace
