#include "core/evaluation/trial/branch_distances.h"

#include <gtest/gtest.h>
#include <cmath>

using namespace angiopose;

namespace {

using namespace core;

const ProjectionCamera branchCamera{-1000.0, 1000.0, 100.0, 100.0, 201, 201};

/// A branch along x at a depth of 1000 mm, which projects onto row 100, and one behind the source.
VesselTree twoBranches()
{
    VesselTree tree;
    tree.branches.push_back({4, "", {{-20.0, 0.0, 1000.0}, {0.0, 0.0, 1000.0}, {20.0, 0.0, 1000.0}}, {}});
    tree.branches.push_back({9, "", {{0.0, 0.0, -10.0}, {0.0, 5.0, -10.0}}, {}});
    return tree;
}

TEST(BranchDistances, MeasuresToTheCurveBetweenItsPoints)
{
    Centerline2d target;
    target.curves.push_back({1, {{0.0, 103.0}, {200.0, 103.0}}, {}});
    const auto distances = branchDistances(twoBranches(), target, branchCamera, {});
    ASSERT_EQ(distances.at(4).size(), 3u);
    for (const double distance : distances.at(4)) {
        EXPECT_NEAR(distance, 3.0, 0.02);
    }
}

TEST(BranchDistances, PointsBehindTheSourceAreInfinitelyFar)
{
    Centerline2d target;
    target.curves.push_back({1, {{100.0, 100.0}}, {}});
    const auto distances = branchDistances(twoBranches(), target, branchCamera, {});
    for (const double distance : distances.at(9)) {
        EXPECT_TRUE(std::isinf(distance));
    }
}

TEST(BranchDistances, NothingTracedGivesNothing)
{
    EXPECT_TRUE(branchDistances(twoBranches(), {}, branchCamera, {}).empty());
}

}   // namespace
