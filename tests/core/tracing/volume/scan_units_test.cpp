#include "core/messages/messages.h"
#include "core/simulation/simulate_cta.h"
#include "core/tracing/volume/trace_vessels.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace angiopose;

namespace {

/// The same scan with all values shifted by `offset`; a single branch is enough.
core::Volume scanMovedBy(std::int16_t offset)
{
    core::Volume scan = core::simulateCta(3, {.branchCount = 2, .rootRadiusMm = 4.0},
                                          {.size = {80, 80, 72}, .spacingMm = {1.2, 1.2, 1.2}, .calcificationCount = 1})
                            .volume;
    std::ranges::transform(scan.voxels, scan.voxels.begin(),
                           [offset](std::int16_t value) { return static_cast<std::int16_t>(value + offset); });
    return scan;
}

bool warnsOfUnits(const core::Volume& scan, const core::VesselTracingOptions& options = {})
{
    const auto traced = core::traceVessels(scan, options);
    EXPECT_TRUE(traced) << traced.error().message;
    return traced && std::ranges::any_of(traced.value().warnings, [](const core::Message& warning) {
               return warning.is(core::messages::possiblyNotHounsfield);
           });
}

TEST(ScanUnits, OtherThanHounsfieldAreWarnedAbout)
{
    const core::Volume scan = scanMovedBy(0);
    const core::Volume moved = scanMovedBy(1024);
    ASSERT_LT(*std::ranges::min_element(scan.voxels), -500);
    EXPECT_FALSE(warnsOfUnits(scan));
    EXPECT_TRUE(warnsOfUnits(moved));
    const auto traced = core::traceVessels(moved);
    ASSERT_TRUE(traced);
    EXPECT_TRUE(warnsOfUnits(moved, {.seedsInPatient = {traced.value().tree.branches.front().pointsInPatient[10]}}));
}

TEST(ScanUnits, HounsfieldAreKnownWithoutAir)
{
    core::Volume scan = scanMovedBy(0);
    const auto whole = core::traceVessels(scan);
    std::ranges::transform(scan.voxels, scan.voxels.begin(),
                           [](std::int16_t value) { return value < -300 ? std::int16_t{-100} : value; });
    ASSERT_GT(*std::ranges::min_element(scan.voxels), -500);
    EXPECT_FALSE(warnsOfUnits(scan));
    const auto airless = core::traceVessels(scan);
    ASSERT_TRUE(whole && airless);
    EXPECT_NEAR(airless.value().threshold, whole.value().threshold, 10.0);
    EXPECT_EQ(airless.value().tree.branches.size(), whole.value().tree.branches.size());
}

TEST(ScanUnits, NoiseAroundAirThatCountsAsZeroIsNoFat)
{
    const core::Volume scan = scanMovedBy(1000);
    ASSERT_LT(*std::ranges::min_element(scan.voxels), -20);
    EXPECT_TRUE(warnsOfUnits(scan));
}

}   // namespace
