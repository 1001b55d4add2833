#include "core/tracing/tree/skeleton_coverage.h"

#include "core/messages/messages.h"
#include "core/tracing/volume/trace_vessels.h"
#include "tests/support/drawn_tubes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace angiopose;

namespace {

core::VesselTree lineTo(double endMm)
{
    core::VesselBranch branch;
    branch.id = 1;
    branch.pointsInPatient = {{0.0, 5.0, 5.0}, {endMm, 5.0, 5.0}};
    branch.radiusMm = {1.0, 1.0};
    core::VesselTree tree;
    tree.branches = {branch};
    return tree;
}

TEST(SkeletonCoverage, SaysHowMuchIsFollowedAndWhereMostIsNot)
{
    core::VolumeGeometry grid;
    grid.size = {101, 11, 11};
    std::vector<std::size_t> skeleton;
    for (int i = 0; i <= 100; ++i) {
        skeleton.push_back(grid.index(i, 6, 5));   // one voxel off the line
    }
    const core::SkeletonCoverage half = core::measureCoverage(grid, skeleton, lineTo(59.0));
    EXPECT_NEAR(half.fraction, 0.6, 0.02);
    ASSERT_TRUE(half.missedInPatient);
    EXPECT_NEAR(half.missedInPatient->x(), 80.0, 2.0);
    const core::SkeletonCoverage whole = core::measureCoverage(grid, skeleton, lineTo(100.0));
    EXPECT_EQ(whole.fraction, 1.0);
    EXPECT_FALSE(whole.missedInPatient);
}

bool reportsSkeleton(const core::VesselTracingOptions& options)
{
    const auto grid = test::gridAround({0, 0, 0}, {60, 50, 60}, {1.0, 1.0, 1.0});
    const auto traced = core::traceMask(
        test::drawnMask(grid, {{{0, 0, -25}, {0, 0, 25}, 4.0}, {{0, 0, 0}, {24, 0, 10}, 2.0}}), options);
    EXPECT_TRUE(traced);
    return traced && std::ranges::any_of(traced.value().warnings, [](const core::Message& warning) {
               return warning.is(core::messages::skeletonNotFollowed);
           });
}

TEST(SkeletonCoverage, OfAMaskIsToldWhereItIsNotFollowed)
{
    EXPECT_FALSE(reportsSkeleton({}));
    EXPECT_TRUE(reportsSkeleton({.minBranchRadiusMm = 3.0}));
}

}   // namespace
