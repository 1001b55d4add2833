#include "core/simulation/simulate_cta.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

TEST(SimulateCta, IsTheSameForTheSameSeed)
{
    const CtaOptions tiny{.size = {40, 40, 30}, .spacingMm = {2.0, 2.0, 2.0}};
    EXPECT_EQ(simulateCta(7, {.branchCount = 3}, tiny).volume.voxels,
              simulateCta(7, {.branchCount = 3}, tiny).volume.voxels);
    EXPECT_NE(simulateCta(7, {.branchCount = 3}, tiny).volume.voxels,
              simulateCta(8, {.branchCount = 3}, tiny).volume.voxels);
}

TEST(SimulateCta, IsBrightInTheVesselsAndDarkOutsideTheBody)
{
    const SimulatedCta cta =
        simulateCta(3, {.branchCount = 6, .rootRadiusMm = 4.0}, {.size = {112, 112, 96}, .spacingMm = {1.0, 1.0, 1.0}});
    const Volume& volume = cta.volume;
    const VesselBranch& trunk = cta.tree.branches.front();
    const Eigen::Vector3d middle = trunk.pointsInPatient[trunk.pointsInPatient.size() / 2];
    const Eigen::Vector3i voxel = (volume.geometry.patientFromVoxel().inverse() * middle).array().round().cast<int>();
    EXPECT_NEAR(volume.value(volume.geometry.index(voxel.x(), voxel.y(), voxel.z())), 380.0, 120.0);
    EXPECT_LT(volume.value(0), -850.0);
}

}   // namespace
