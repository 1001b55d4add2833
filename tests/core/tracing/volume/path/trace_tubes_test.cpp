#include "core/tracing/volume/path/trace_tubes.h"

#include "core/messages/says.h"
#include "core/simulation/simulate_body.h"
#include "tests/support/tree_agreement.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

/// A coarser scan than the usual one, so that tests are quick.
const BodyScan& heart()
{
    static const BodyScan scan = simulateHeart(4, {.spacingMm = {0.7, 0.7, 0.8}});
    return scan;
}

VesselTracingOptions fromOrigins(const BodyScan& scan)
{
    return {.seedsInPatient = scan.origins, .tubesOnly = true};
}

TEST(TraceTubes, FindsCoronaryArteriesBesideFilledChambers)
{
    const auto traced = traceVessels(heart().volume, fromOrigins(heart()));
    ASSERT_TRUE(traced) << traced.error().message.text();
    const auto agreement = test::agreementOf(traced.value().tree, heart().arteries, 0.8);
    EXPECT_GT(agreement.found, 0.8);
    EXPECT_GT(agreement.right, 0.9);
    EXPECT_FALSE(findProblem(traced.value().tree));
    // As everything bright and connected, the seeds' vessels are mostly chambers.
    VesselTracingOptions all = fromOrigins(heart());
    all.tubesOnly = false;
    const auto connected = traceVessels(heart().volume, all);
    EXPECT_TRUE(!connected || test::agreementOf(connected.value().tree, heart().arteries, 0.8).right < agreement.right);
}

TEST(TraceTubes, ParentsComeBeforeTheirBranchesAndTheMaskHoldsThem)
{
    const auto traced = traceTubes(heart().volume, fromOrigins(heart()));
    ASSERT_TRUE(traced);
    int id = 0;
    for (const VesselBranch& branch : traced.value().tree.branches) {
        EXPECT_EQ(branch.id, ++id);
        EXPECT_GE(branch.generation, 0);
        const Eigen::Vector3i middle = (heart().volume.geometry.patientFromVoxel().inverse() *
                                        branch.pointsInPatient[branch.pointsInPatient.size() / 2])
                                           .array()
                                           .round()
                                           .cast<int>();
        EXPECT_NE(traced.value().lumen.at(middle.x(), middle.y(), middle.z()), 0);
    }
    EXPECT_GT(traced.value().threshold, 0.0);
    EXPECT_LT(traced.value().threshold, 400.0);
}

TEST(TraceTubes, AsksForASeedAndSaysWhereNoneLeadsOn)
{
    const auto unseeded = traceTubes(heart().volume, {.tubesOnly = true});
    ASSERT_FALSE(unseeded);
    EXPECT_TRUE(unseeded.error().message.is(says::tubesNeedSeed));
    Volume chamber(heart().volume.geometry);   // blood everywhere
    for (std::int16_t& voxel : chamber.voxels) {
        voxel = 400;
    }
    chamber.voxels.front() = 0;
    const auto nothing = traceTubes(chamber, {.seedsInPatient = {{0.0, 0.0, 0.0}}, .tubesOnly = true});
    ASSERT_FALSE(nothing);
    EXPECT_TRUE(nothing.error().message.is(says::pathEndInNothing)) << nothing.error().message.text();
}

TEST(TraceTubes, HearsAStop)
{
    const auto stopped =
        traceTubes(heart().volume, fromOrigins(heart()), [](const TracingReport&) { return Verdict::Stop; });
    EXPECT_TRUE(stopped.isStopped());
}

}   // namespace
