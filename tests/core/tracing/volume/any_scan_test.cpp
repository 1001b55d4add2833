#include "core/messages/messages.h"
#include "core/tracing/volume/trace_vessels.h"
#include "tests/support/bodies/simulate_any_scan.h"
#include "tests/support/tree_agreement.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace angiopose;

namespace {

core::AnyScan scanOf(core::ScanKind kind)
{
    return core::simulateAnyScan(kind, 3, core::ScanRanges::Choosing);
}

double falseShare(const core::VesselTree& tree, const core::AnyScan& scan)
{
    core::VesselTree truth = scan.arteries;
    truth.branches.insert(truth.branches.end(), scan.upstream.branches.begin(), scan.upstream.branches.end());
    return 1.0 - test::agreementOf(tree, truth, scan.volume.geometry.spacingMm.maxCoeff()).right;
}

TEST(AnyScan, SinusesFilledAsArteriesAreAskedAbout)
{
    const auto traced = core::traceVessels(scanOf(core::ScanKind::HeadCtaAboveBase).volume);
    ASSERT_FALSE(traced);
    EXPECT_TRUE(traced.error().message.is(core::messages::headNeedsSeed)) << traced.error().message;
}

TEST(AnyScan, InflowInMrIsTracedFromTheNeckOn)
{
    const core::AnyScan scan = scanOf(core::ScanKind::HeadTofSlab);
    const auto traced = core::traceVessels(scan.volume);
    ASSERT_TRUE(traced) << traced.error().message;
    EXPECT_LT(falseShare(traced.value().tree, scan), 0.1);
    EXPECT_LT(traced.value().tree.branches.front().pointsInPatient.front().z(), -55.0);
}

TEST(AnyScan, AFilledCarotidInRotationalAngiographyIsTraced)
{
    const core::AnyScan scan = scanOf(core::ScanKind::HeadRotational);
    const auto traced = core::traceVessels(scan.volume);
    ASSERT_TRUE(traced) << traced.error().message;
    EXPECT_LT(falseShare(traced.value().tree, scan), 0.1);
    EXPECT_GT(test::agreementOf(traced.value().tree, scan.seen, 1.0).found, 0.8);
}

TEST(AnyScan, TheFallOffOfACoilIsCorrectedAndReported)
{
    const core::AnyScan scan = scanOf(core::ScanKind::BodyMra);
    const auto traced = core::traceVessels(scan.volume);
    ASSERT_TRUE(traced) << traced.error().message;
    EXPECT_LT(falseShare(traced.value().tree, scan), 0.1);
    EXPECT_GT(test::agreementOf(traced.value().tree, scan.seen, 1.5).found, 0.9);
    EXPECT_TRUE(std::ranges::any_of(traced.value().warnings, [](const core::Message& warning) {
        return warning.is(core::messages::coilBiasCorrected);
    }));
}

TEST(AnyScan, CtWithoutHounsfieldUnitsHasNoCoil)
{
    const core::AnyScan scan = scanOf(core::ScanKind::AbdomenGray);
    const auto traced = core::traceVessels(scan.volume);
    ASSERT_TRUE(traced) << traced.error().message;
    EXPECT_LT(falseShare(traced.value().tree, scan), 0.05);
    EXPECT_TRUE(std::ranges::none_of(traced.value().warnings, [](const core::Message& warning) {
        return warning.is(core::messages::coilBiasCorrected);
    }));
}

}   // namespace
