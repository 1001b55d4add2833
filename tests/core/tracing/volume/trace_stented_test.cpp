#include "core/simulation/simulate_cta.h"
#include "core/simulation/stent_wires.h"
#include "core/tracing/volume/trace_vessels.h"
#include "tests/support/drawn_tubes.h"
#include "tests/support/tree_agreement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

using namespace angiopose;

namespace {

using core::Volume;
using test::shareNear;
using test::Tube;

/// A simulated CTA whose first branch contains a stent.
core::SimulatedCta stentedCta(double rootRadiusMm, double voxelMm)
{
    const int across = static_cast<int>(120.0 / voxelMm);
    return core::simulateCta(3, {.branchCount = 6, .rootRadiusMm = rootRadiusMm},
                             {.size = {across, across, across},
                              .spacingMm = Eigen::Vector3d::Constant(voxelMm),
                              .calcificationCount = 4,
                              .hasStent = true});
}

/// Traces the tree; the test fails if the found or correct share is below the given minimum.
core::VesselTree tracedTree(const core::SimulatedCta& cta, double minFound, double minRight)
{
    auto traced = core::traceVessels(cta.volume);
    if (!traced) {
        ADD_FAILURE() << traced.error().message;
        return {};
    }
    EXPECT_GT(shareNear(cta.tree, traced.value().tree, 2.0), minFound);
    EXPECT_GT(shareNear(traced.value().tree, cta.tree, 2.0), minRight);
    return std::move(traced).value().tree;
}

TEST(TraceStented, GoesOnThroughAStentInAThinVessel)
{
    for (const double voxelMm : {1.0, 0.75}) {
        SCOPED_TRACE(voxelMm);
        const core::SimulatedCta cta = stentedCta(4.5, voxelMm);
        const core::VesselTree tree = tracedTree(cta, 0.9, 0.95);
        EXPECT_NEAR(static_cast<double>(tree.branches.size()), static_cast<double>(cta.tree.branches.size()), 1.0);
    }
}

TEST(TraceStented, GoesOnThroughAStentWithoutVisibleBlood)
{
    for (const double rootRadiusMm : {4.0, 5.0}) {   // 2.2 and 2.7 mm at the stent
        const core::SimulatedCta cta =
            core::simulateCta(2, {.branchCount = 6, .rootRadiusMm = rootRadiusMm},
                              {.size = {120, 120, 120}, .spacingMm = {1.0, 1.0, 1.0}, .hasStent = true});
        SCOPED_TRACE(rootRadiusMm);
        (void)tracedTree(cta, 0.93, 0.95);
    }
}

TEST(TraceStented, MeasuresAStentedVesselAtItsWires)
{
    for (const double voxelMm : {1.0, 0.75}) {
        for (const double rootRadiusMm : {3.6, 6.5}) {
            const core::SimulatedCta cta = stentedCta(rootRadiusMm, voxelMm);
            const auto traced = core::traceVessels(cta.volume);
            ASSERT_TRUE(traced) << traced.error().message;
            const core::VesselBranch& stented = cta.tree.branches.front();
            const auto error = test::radiusErrorInStentMm(traced.value().tree, stented);
            ASSERT_TRUE(error);
            EXPECT_LT(std::abs(*error), 0.1 * stented.radiusMm[stented.radiusMm.size() / 2])
                << rootRadiusMm << " in " << voxelMm;
        }
    }
}

TEST(TraceStented, TakesAWideVesselUpToTheWires)
{
    for (const double voxelMm : {1.0, 0.75}) {
        const core::SimulatedCta cta = stentedCta(8.5, voxelMm);
        const auto traced = core::traceVessels(cta.volume);
        ASSERT_TRUE(traced) << traced.error().message;
        const core::VesselBranch& stented = cta.tree.branches.front();
        const auto error = test::radiusErrorInStentMm(traced.value().tree, stented);
        ASSERT_TRUE(error);
        EXPECT_LT(std::abs(*error), 0.15 * stented.radiusMm[stented.radiusMm.size() / 2]) << voxelMm;
    }
}

TEST(TraceStented, FindsBranchesThatLeaveBetweenTheWires)
{
    for (const double voxelMm : {1.0, 0.75}) {
        SCOPED_TRACE(voxelMm);
        (void)tracedTree(stentedCta(8.5, voxelMm), 0.9, 0.93);
    }
}

TEST(TraceStented, KnowsAStentThatLiesOnBone)
{
    for (const std::uint64_t seed : {6U, 8U}) {   // the struts are connected to a vertebra
        const core::SimulatedCta cta = core::simulateCta(
            seed, {.branchCount = 6, .rootRadiusMm = seed == 6 ? 7.5 : 10.0},
            {.size = {160, 160, 160}, .spacingMm = {0.75, 0.75, 0.75}, .calcificationCount = 4, .hasStent = true});
        const auto traced = core::traceVessels(cta.volume);
        ASSERT_TRUE(traced) << traced.error().message;
        EXPECT_GT(shareNear(cta.tree, traced.value().tree, 2.0), 0.9) << seed;
    }
}

/// Adds struts as bright as metal in this scan, about two voxels thick.
void addStent(Volume& volume, const core::VesselBranch& branch)
{
    const Eigen::Affine3d voxelFromPatient = volume.geometry.patientFromVoxel().inverse();
    for (const core::VesselBranch& wire : core::stentWires(branch).branches) {
        for (const Eigen::Vector3d& point : wire.pointsInPatient) {
            const Eigen::Vector3i low = (voxelFromPatient * point).array().floor().cast<int>();
            volume.at(low.x(), low.y(), low.z()) = 2800;
            volume.at(low.x() + 1, low.y() + 1, low.z()) = 1200;
        }
    }
}

TEST(TraceStented, KeepsWithinTheStentOfAWideVessel)
{
    const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {64, 48, 130}, {1.0, 1.0, 1.0});
    const Tube stented{{-9, 0, -62}, {-9, 0, 62}, 9.0};
    const Tube falseLumen{{10, 0, -62}, {10, 0, 62}, 8.5};   // of a dissected aorta, separated by the flap
    Volume volume = test::tubesInTissue(grid, {stented, falseLumen});
    core::VesselBranch axis;
    for (double z = -62.0; z <= 62.0; z += 1.0) {
        axis.pointsInPatient.emplace_back(-9, 0, z);
        axis.radiusMm.push_back(9.0);
    }
    addStent(volume, axis);
    const auto traced = core::traceVessels(volume, {.seedsInPatient = {{-9, 0, -50}}});
    ASSERT_TRUE(traced) << traced.error().message;
    for (const Eigen::Vector3d& point : axis.pointsInPatient) {
        EXPECT_LT(test::distanceTo(traced.value().tree, point), 2.0) << point.transpose();
    }
    EXPECT_EQ(traced.value().tree.branches.size(), 1U);
}

}   // namespace
