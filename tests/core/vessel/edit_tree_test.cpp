#include "core/vessel/edit_tree.h"
#include "core/vessel/root_tree.h"
#include "core/vessel/tree_gaps.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace angiopose;

namespace {

using core::VesselBranch;
using core::VesselTree;

VesselBranch straightBranch(int id, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radiusMm)
{
    VesselBranch branch;
    branch.id = id;
    const int steps = static_cast<int>(std::lround((to - from).norm()));
    for (int n = 0; n <= steps; ++n) {
        branch.pointsInPatient.emplace_back(from + (to - from) * n / steps);
        branch.radiusMm.push_back(radiusMm);
    }
    return branch;
}

/// A trunk along z with two side branches, one of which branches again.
VesselTree smallTree()
{
    VesselTree tree;
    tree.branches = {straightBranch(1, {0, 0, 0}, {0, 0, 60}, 4.0), straightBranch(4, {0, 0, 20}, {30, 0, 20}, 2.0),
                     straightBranch(6, {0, 0, 40}, {-25, 0, 40}, 1.5),
                     straightBranch(9, {15, 0, 20}, {15, 8, 20}, 0.8)};
    tree.branches[0].name = "trunk";
    const int generations[] = {0, 1, 1, 2};
    for (std::size_t b = 0; b < 4; ++b) {
        tree.branches[b].generation = generations[b];
    }
    return tree;
}

std::vector<int> idsInOrder(const VesselTree& tree)
{
    std::vector<int> ids;
    for (const VesselBranch& branch : tree.branches) {
        ids.push_back(branch.id);
    }
    return ids;
}

TEST(EditTree, DeletesABranchWithAllThatLeavesIt)
{
    EXPECT_EQ(idsInOrder(core::removeSubtree(smallTree(), 4).value()), (std::vector<int>{1, 6}));
    EXPECT_EQ(idsInOrder(core::removeSubtree(smallTree(), 9).value()), (std::vector<int>{1, 4, 6}));
    EXPECT_FALSE(core::removeSubtree(smallTree(), 1));
    EXPECT_FALSE(core::removeSubtree(smallTree(), 2));
}

TEST(EditTree, PrunesShortAndThinEndBranches)
{
    EXPECT_EQ(idsInOrder(core::pruneTree(smallTree(), 10.0, 0.0).value()), (std::vector<int>{1, 4, 6}));
    EXPECT_EQ(idsInOrder(core::pruneTree(smallTree(), 0.0, 1.8).value()), (std::vector<int>{1, 4}));
    // Branch 4 is thin but supports branch 9 until that is removed.
    EXPECT_EQ(idsInOrder(core::pruneTree(smallTree(), 0.0, 3.0).value()), (std::vector<int>{1}));
    EXPECT_FALSE(core::pruneTree(smallTree(), 100.0, 0.0));
    EXPECT_EQ(idsInOrder(core::pruneTree(smallTree(), 0.0, 0.0).value()), idsInOrder(smallTree()));
}

TEST(EditTree, CutsAndJoinsBack)
{
    const auto cut = core::splitAt(smallTree(), 1, 29);
    ASSERT_TRUE(cut);
    EXPECT_EQ(idsInOrder(cut.value()), (std::vector<int>{1, 4, 6, 9, 10}));
    EXPECT_EQ(cut.value().find(1)->pointsInPatient.size(), 30U);
    EXPECT_EQ(cut.value().find(10)->pointsInPatient.front(), Eigen::Vector3d(0, 0, 30));
    EXPECT_EQ(cut.value().find(10)->radiusMm.size(), 31U);
    EXPECT_EQ(cut.value().find(1)->name, "trunk");
    const auto again = core::joinBranches(cut.value(), 1, 10);
    ASSERT_TRUE(again);
    EXPECT_EQ(again.value().find(1)->pointsInPatient, smallTree().find(1)->pointsInPatient);
    EXPECT_EQ(again.value().find(1)->radiusMm, smallTree().find(1)->radiusMm);
    EXPECT_FALSE(core::splitAt(smallTree(), 1, 0));
    EXPECT_FALSE(core::splitAt(smallTree(), 1, 59));
    EXPECT_FALSE(core::splitAt(smallTree(), 1, 600));
    EXPECT_FALSE(core::splitAt(smallTree(), 2, 5));
}

TEST(EditTree, JoinsNearestEndsWhicheverWayTheyRun)
{
    VesselTree tree;
    tree.branches = {straightBranch(1, {0, 0, 10}, {0, 0, 0}, 2.0), straightBranch(2, {0, 0, 30}, {0, 0, 16}, 3.0)};
    const auto joinBranches = core::joinBranches(tree, 1, 2);
    ASSERT_TRUE(joinBranches);
    ASSERT_EQ(joinBranches.value().branches.size(), 1U);
    const VesselBranch& branch = joinBranches.value().branches.front();
    EXPECT_EQ(branch.pointsInPatient.front(), Eigen::Vector3d(0, 0, 30));
    EXPECT_EQ(branch.pointsInPatient.back(), Eigen::Vector3d(0, 0, 0));
    EXPECT_NEAR(branch.lengthMm(), 30.0, 1e-9);
    ASSERT_EQ(branch.radiusMm.size(), branch.pointsInPatient.size());
    EXPECT_GT(branch.radiusMm[17], 2.0);
    EXPECT_LT(branch.radiusMm[17], 3.0);
    tree.branches[1].radiusMm.clear();
    EXPECT_TRUE(core::joinBranches(tree, 1, 2).value().branches.front().radiusMm.empty());
    EXPECT_FALSE(core::joinBranches(tree, 1, 1));
    EXPECT_FALSE(core::joinBranches(tree, 1, 7));
}

TEST(EditTree, SmoothsNarrowDeformationAndKeepsWideOnesAndEnds)
{
    VesselTree tree;
    tree.branches.emplace_back();
    tree.branches[0].id = 3;
    for (int n = 0; n <= 100; ++n) {
        tree.branches[0].pointsInPatient.emplace_back(std::sin(n / 16.0) * 10.0 + (n % 2 == 0 ? 0.4 : -0.4), 0.0, n);
    }
    const auto smooth = core::smoothBranch(tree, 3, 8.0);
    ASSERT_TRUE(smooth);
    const auto& points = smooth.value().branches[0].pointsInPatient;
    EXPECT_EQ(points.front(), tree.branches[0].pointsInPatient.front());
    EXPECT_EQ(points.back(), tree.branches[0].pointsInPatient.back());
    for (std::size_t n = 10; n < 90; ++n) {
        EXPECT_NEAR(points[n].x(), std::sin(static_cast<double>(n) / 16.0) * 10.0, 0.25);
    }
    EXPECT_FALSE(core::smoothBranch(tree, 4, 8.0));
}

TEST(EditTree, RenamesOneBranch)
{
    const auto named = core::renameBranch(smallTree(), 6, "left renal");
    ASSERT_TRUE(named);
    EXPECT_EQ(named.value().find(6)->name, "left renal");
    EXPECT_EQ(named.value().find(1)->name, "trunk");
    EXPECT_FALSE(core::renameBranch(smallTree(), 5, "x"));
}

TEST(RootTree, KeepsATreeThatHasItsRootAlready)
{
    const VesselTree rooted = core::rootTreeAt(smallTree(), {1, 0, -2});
    EXPECT_EQ(idsInOrder(rooted), idsInOrder(smallTree()));
    for (std::size_t b = 0; b < 4; ++b) {
        EXPECT_EQ(rooted.branches[b].generation, smallTree().branches[b].generation);
        EXPECT_EQ(rooted.branches[b].pointsInPatient, smallTree().branches[b].pointsInPatient);
    }
}

TEST(RootTree, TurnsTheTrunkAroundForARootAtItsOtherEnd)
{
    const VesselTree rooted = core::rootTreeAt(smallTree(), {0, 0, 65});
    ASSERT_EQ(rooted.branches.size(), 4U);
    EXPECT_EQ(rooted.branches[0].id, 1);
    EXPECT_EQ(rooted.branches[0].pointsInPatient.front(), Eigen::Vector3d(0, 0, 60));
    EXPECT_EQ(rooted.find(9)->generation, 2);
    EXPECT_EQ(rooted.find(9)->pointsInPatient.front(), Eigen::Vector3d(15, 0, 20));
}

TEST(RootTree, PartsTheBranchThatIsEnteredInItsMiddle)
{
    const VesselTree rooted = core::rootTreeAt(smallTree(), {32, 0, 20});
    ASSERT_EQ(rooted.branches.size(), 5U);
    EXPECT_EQ(rooted.branches[0].id, 4);
    EXPECT_EQ(rooted.branches[0].pointsInPatient.front(), Eigen::Vector3d(30, 0, 20));
    EXPECT_EQ(rooted.find(9)->generation, 1);
    EXPECT_EQ(rooted.find(1)->generation, 1);
    EXPECT_EQ(rooted.find(1)->pointsInPatient.front(), Eigen::Vector3d(0, 0, 20));
    EXPECT_EQ(rooted.find(1)->pointsInPatient.back(), Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(rooted.find(10)->pointsInPatient.back(), Eigen::Vector3d(0, 0, 60));
    EXPECT_EQ(rooted.find(6)->generation, 2);
    double length = 0.0;
    double before = 0.0;
    for (const VesselBranch& branch : rooted.branches) {
        length += branch.lengthMm();
    }
    for (const VesselBranch& branch : smallTree().branches) {
        before += branch.lengthMm();
    }
    EXPECT_NEAR(length, before, 1e-9);
}

TEST(RootTree, StartsOtherPiecesAtTheirThickEnd)
{
    VesselTree tree = smallTree();
    tree.branches.push_back(straightBranch(12, {100, 0, 0}, {100, 0, 20}, 1.0));
    tree.branches.back().radiusMm.back() = 9.0;
    const VesselTree rooted = core::rootTreeAt(tree, {0, 0, 0});
    EXPECT_EQ(rooted.branches.back().id, 12);
    EXPECT_EQ(rooted.branches.back().generation, 0);
    EXPECT_EQ(rooted.branches.back().pointsInPatient.front(), Eigen::Vector3d(100, 0, 20));
    EXPECT_TRUE(core::rootTreeAt({}, {0, 0, 0}).branches.empty());
}

TEST(TreeGaps, SeesNoneInAWholeTree)
{
    EXPECT_TRUE(core::findGaps(smallTree()).empty());
    EXPECT_TRUE(core::findGaps({}).empty());
}

TEST(TreeGaps, AdvisesToMendABrokenVessel)
{
    VesselTree tree = smallTree();
    tree.branches.push_back(straightBranch(12, {36, 0.5, 20}, {50, 1, 20}, 1.8));   // continues where branch 4 ends
    tree.branches.push_back(straightBranch(13, {0, 9, 50}, {0, 30, 50}, 1.0));   // detached from the trunk
    tree.branches.push_back(straightBranch(14, {0, 200, 0}, {0, 230, 0}, 1.0));   // part of another structure
    const std::vector<core::TreeGap> gaps = core::findGaps(tree);
    ASSERT_EQ(gaps.size(), 2U);
    EXPECT_EQ(gaps[0].fromBranchId + gaps[0].toBranchId, 4 + 12);
    EXPECT_TRUE(gaps[0].toIsEnd);
    EXPECT_NEAR(gaps[0].distanceMm, 6.0, 0.1);
    EXPECT_GT(gaps[0].directionAgreement, 0.95);
    EXPECT_EQ(gaps[1].fromBranchId, 13);
    EXPECT_EQ(gaps[1].toBranchId, 1);
    EXPECT_FALSE(gaps[1].toIsEnd);
    EXPECT_NEAR(gaps[1].distanceMm, 9.0, 1e-9);
    EXPECT_TRUE(core::findGaps(tree, 3.0).empty());
}

TEST(TreeGaps, AreClosedByJoiningEndsOrLeadingOnToASide)
{
    VesselTree tree = smallTree();
    tree.branches.push_back(straightBranch(12, {36, 0.5, 20}, {50, 1, 20}, 1.8));
    tree.branches.push_back(straightBranch(13, {0, 9, 50}, {0, 30, 50}, 1.0));
    EXPECT_EQ(core::componentCount(tree), 3);

    for (int round = 0; round < 2; ++round) {
        const std::vector<core::TreeGap> gaps = core::findGaps(tree);
        ASSERT_FALSE(gaps.empty());
        const auto whole = core::closeGap(tree, gaps.front());
        ASSERT_TRUE(whole) << whole.error().message;
        tree = whole.value();
    }
    EXPECT_EQ(core::componentCount(tree), 1);
    EXPECT_EQ(tree.branches.size(),
              smallTree().branches.size() + 1);   // one pair is joined, branch 13 is extended to the trunk
    EXPECT_NEAR(tree.find(13)->pointsInPatient.front().y(), 0.0, 1e-9);
    EXPECT_EQ(tree.find(13)->radiusMm.size(), tree.find(13)->pointsInPatient.size());
    EXPECT_TRUE(core::findGaps(tree).empty());
}

TEST(EditTree, CountsABranchAsAskedAndFindsItsNearestPoint)
{
    EXPECT_EQ(core::assignGeneration(smallTree(), 4, 3).value().find(4)->generation, 3);
    EXPECT_EQ(core::assignGeneration(smallTree(), 4, -7).value().find(4)->generation, -1);
    EXPECT_FALSE(core::assignGeneration(smallTree(), 99, 1));
    const std::size_t point = core::nearestPoint(smallTree(), 1, {2, 0, 31.2});
    EXPECT_NEAR(smallTree().find(1)->pointsInPatient[point].z(), 31.0, 1.01);
}

TEST(EditTree, LeadsABranchOnFromEitherEnd)
{
    const auto longer = core::extendBranchTo(smallTree(), {1, false}, {0, 0, -8});
    ASSERT_TRUE(longer);
    EXPECT_EQ(longer.value().find(1)->pointsInPatient.front(), Eigen::Vector3d(0, 0, -8));
    EXPECT_NEAR(longer.value().find(1)->lengthMm(), smallTree().find(1)->lengthMm() + 8.0, 1e-9);
    EXPECT_EQ(longer.value().find(1)->pointsInPatient.back(), smallTree().find(1)->pointsInPatient.back());
}

}   // namespace
