#include "tests/support/tracing_score.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

/// A small version of the table `tracing_table --simulated`, whose targets are means over many runs.
TEST(SimulatedTracing, FindsVisibleVesselsAndLittleElse)
{
    core::DsaOptions dsa;
    dsa.frameCount = 2;
    for (const std::uint64_t seed : {103U, 104U}) {
        const core::SimulatedCase simulated = core::simulateCase(seed, {}, dsa);
        const auto trace = core::traceAngiogram(
            simulated.angiogram.frames[static_cast<std::size_t>(simulated.angiogram.suggestedFrame)],
            simulated.angiogram.polarity);
        ASSERT_TRUE(trace) << trace.error().message;
        const test::TracingScore score = test::scoreTracing(simulated, trace.value());
        EXPECT_GT(score.visiblePx, 500.0) << seed;
        EXPECT_GT(score.recall(), 0.88) << seed;
        EXPECT_LT(score.falseUnsuspectedPx, 0.1 * score.tracedPx) << seed;
        EXPECT_LT(score.biasPx, 0.2) << seed;
    }
}

TEST(SimulatedTracing, TheScoreTellsNothingFromAll)
{
    core::DsaOptions dsa;
    dsa.frameCount = 1;
    dsa.catheterProbability = 1.0;
    const core::SimulatedCase simulated = core::simulateCase(7, {}, dsa);
    core::AngiogramTrace trace;
    EXPECT_EQ(test::scoreTracing(simulated, trace).recall(), 0.0);
    trace.centerline = simulated.trueTarget;
    const test::TracingScore perfect = test::scoreTracing(simulated, trace);
    EXPECT_EQ(perfect.recall(), 1.0);
    EXPECT_EQ(perfect.falsePx, 0.0);
    EXPECT_LT(perfect.curveBiasPx, 0.05);
    trace.centerline = simulated.trueCatheter;
    ASSERT_FALSE(trace.centerline.curves.empty());
    EXPECT_EQ(test::scoreTracing(simulated, trace).falsePx, 0.0) << "a catheter is no vessel, but it is there";
    for (core::Curve2d& curve : trace.centerline.curves) {
        for (Eigen::Vector2d& point : curve.pointsPx) {
            point += Eigen::Vector2d(-7000.0, 0.0);
        }
    }
    EXPECT_EQ(test::scoreTracing(simulated, trace).falseShare(), 1.0);
}

}   // namespace
