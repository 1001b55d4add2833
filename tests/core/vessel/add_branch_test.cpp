#include "core/vessel/add_branch.h"

#include "core/messages/messages.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

/// A straight trunk along x, 3 mm wide.
VesselTree trunk(int generation = 0)
{
    VesselTree tree;
    VesselBranch branch{4, "", {}, {}, generation};
    for (int x = 0; x <= 40; ++x) {
        branch.pointsInPatient.emplace_back(x, 0.0, 0.0);
        branch.radiusMm.push_back(3.0);
    }
    tree.branches.push_back(std::move(branch));
    return tree;
}

/// A branch along the trunk's edge from x = 15 to 20, then away from it along y to 20 mm.
VesselBranch leaving()
{
    VesselBranch branch;
    for (int x = 15; x < 20; ++x) {
        branch.pointsInPatient.emplace_back(x, 1.0, 0.0);
    }
    for (int y = 1; y <= 20; ++y) {
        branch.pointsInPatient.emplace_back(20.0, y, 0.0);
    }
    branch.radiusMm.assign(branch.pointsInPatient.size(), 1.0);
    return branch;
}

TEST(AddBranch, LeavesOutWhatRunsInsideAndBeginsOnTheAxis)
{
    const VesselTree tree = attachBranch(trunk(), leaving()).value();
    ASSERT_EQ(tree.branches.size(), 2U);
    const VesselBranch& added = tree.branches.back();
    EXPECT_EQ(added.id, 5);
    EXPECT_EQ(added.generation, 1);
    EXPECT_EQ(added.pointsInPatient.front(), Eigen::Vector3d(20.0, 0.0, 0.0));
    EXPECT_EQ(added.pointsInPatient[1], Eigen::Vector3d(20.0, 4.0, 0.0));
    EXPECT_EQ(added.pointsInPatient.back(), Eigen::Vector3d(20.0, 20.0, 0.0));
    EXPECT_EQ(added.radiusMm.size(), added.pointsInPatient.size());
    EXPECT_FALSE(findProblem(tree));
    EXPECT_EQ(findNodes(tree).front().branchIds.size(), 1U);
}

TEST(AddBranch, BeginsInTheTreeWhicheverEndWasPlacedFirst)
{
    VesselBranch turned = leaving();
    std::ranges::reverse(turned.pointsInPatient);
    const VesselBranch forth = attachBranch(trunk(), leaving()).value().branches.back();
    const VesselBranch back = attachBranch(trunk(), turned).value().branches.back();
    EXPECT_EQ(forth.pointsInPatient, back.pointsInPatient);
}

TEST(AddBranch, StandsAloneWhereItTouchesNothing)
{
    VesselBranch away = leaving();
    for (Eigen::Vector3d& point : away.pointsInPatient) {
        point.z() += 50.0;
    }
    const VesselBranch added = attachBranch(trunk(), away).value().branches.back();
    EXPECT_EQ(added.pointsInPatient, away.pointsInPatient);
    EXPECT_EQ(added.generation, -1);
}

TEST(AddBranch, RefusesWhatRunsInsideAltogether)
{
    VesselBranch inside;
    inside.pointsInPatient = {{5.0, 1.0, 0.0}, {10.0, 1.0, 0.0}, {15.0, 1.0, 0.0}};
    const auto refused = attachBranch(trunk(), inside);
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().message.is(messages::branchInsideTracedVessels));
}

TEST(AddBranch, BridgesTwoBranchesAndBelongsToTheOneNearerTheRoot)
{
    VesselTree tree = trunk(3);
    VesselBranch other = trunk(1).branches.front();
    other.id = 9;
    for (Eigen::Vector3d& point : other.pointsInPatient) {
        point.y() += 20.0;
    }
    tree.branches.push_back(other);
    const VesselBranch added = attachBranch(tree, leaving()).value().branches.back();
    EXPECT_EQ(added.generation, 2);
    EXPECT_EQ(added.pointsInPatient.front(), Eigen::Vector3d(20.0, 20.0, 0.0));
    EXPECT_EQ(added.pointsInPatient.back(), Eigen::Vector3d(20.0, 0.0, 0.0));
}

}   // namespace
