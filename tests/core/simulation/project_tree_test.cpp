#include "core/simulation/simulated_case.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

const ProjectionCamera projectingCamera{-1877.0, 1877.0, 255.5, 255.5, 512, 512};

TEST(ProjectTree, GivesOneCurvePerBranchWithThePixelsOfItsPoints)
{
    const VesselTree tree = simulateTree(2);
    const RigidTransform pose{expSo3({0.2, 0.1, -0.4}), {2.0, -3.0, 800.0}};
    const Centerline2d target = projectTree(tree, projectingCamera, pose);
    ASSERT_EQ(target.curves.size(), tree.branches.size());
    for (std::size_t b = 0; b < target.curves.size(); ++b) {
        EXPECT_EQ(target.curves[b].id, tree.branches[b].id);
        ASSERT_EQ(target.curves[b].pointsPx.size(), tree.branches[b].pointsInPatient.size());
        const Eigen::Vector3d x = pose * tree.branches[b].pointsInPatient.back();
        EXPECT_NEAR(target.curves[b].pointsPx.back().x(), -1877.0 * x.x() / x.z() + 255.5, 1e-9);
        EXPECT_NEAR(target.curves[b].pointsPx.back().y(), 1877.0 * x.y() / x.z() + 255.5, 1e-9);
        EXPECT_NEAR(target.curves[b].radiusPx.back(), tree.branches[b].radiusMm.back() * 1877.0 / x.z(), 1e-9);
    }
}

TEST(ProjectTree, LeavesOutPointsBehindTheSource)
{
    VesselTree tree;
    tree.branches.push_back({1, "", {{0, 0, -50}, {0, 0, -20}, {0, 0, 40}, {0, 0, 60}}, {}});
    tree.branches.push_back({2, "", {{0, 0, -50}, {0, 0, -20}}, {}});
    const Centerline2d target = projectTree(tree, projectingCamera, RigidTransform{});
    ASSERT_EQ(target.curves.size(), 1u);
    EXPECT_EQ(target.curves[0].pointsPx.size(), 2u);
    EXPECT_TRUE(target.curves[0].radiusPx.empty());
}

}   // namespace
