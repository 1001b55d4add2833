#include "core/tracing/volume/path/trace_tubes.h"

#include "core/messages/messages.h"
#include "core/support/random.h"
#include "core/tracing/volume/trace_vessels.h"
#include "tests/support/bodies/simulate_body.h"
#include "tests/support/tree_agreement.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

using namespace angiopose;

namespace {

using namespace core;

/// A scan coarser than the default, to keep the tests fast.
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
    // If everything bright and connected is traced, the result from these seeds is mostly heart chambers.
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
    EXPECT_TRUE(unseeded.error().message.is(messages::tubesNeedSeed));
    Volume chamber(heart().volume.geometry);   // blood in all voxels
    for (std::int16_t& voxel : chamber.voxels) {
        voxel = 400;
    }
    chamber.voxels.front() = 0;
    const auto nothing = traceTubes(chamber, {.seedsInPatient = {{0.0, 0.0, 0.0}}, .tubesOnly = true});
    ASSERT_FALSE(nothing);
    EXPECT_TRUE(nothing.error().message.is(messages::pathEndOutsideVessel)) << nothing.error().message.text();
}

/// An artery that ends on a wider vein with half the enhancement, as a hepatic artery on the portal vein.
TEST(TraceTubes, DoesNotGoOnInAVeinThatIsDarkerThoughWider)
{
    VolumeGeometry grid;
    grid.size = {90, 50, 40};
    grid.spacingMm = Eigen::Vector3d::Constant(0.7);
    grid.originInPatient = {-31.0, -16.0, -14.0};
    Volume scan(grid);
    CounterRandom random(3);
    for (std::size_t n = 0; n < scan.voxels.size(); ++n) {
        const Eigen::Vector3d place = grid.patientFromVoxel() * grid.voxelAt(n).cast<double>();
        const double beyondEnd = std::max(0.0, place.x());
        const double toArtery = std::hypot(beyondEnd, place.y(), place.z());
        const double toVein = std::hypot(place.y() - 4.2, place.z());
        const double vein = std::clamp(0.5 + (3.0 - toVein) / 0.9, 0.0, 1.0);
        const double artery = std::clamp(0.5 + (1.4 - toArtery) / 0.9, 0.0, 1.0);
        const double beside = 95.0 + vein * (232.0 - 95.0);
        scan.voxels[n] =
            static_cast<std::int16_t>(std::lround(beside + artery * (400.0 - beside) + 20.0 * random.normal()));
    }
    const auto traced = traceTubes(scan, {.seedsInPatient = {{-22.0, 0.0, 0.0}}, .tubesOnly = true});
    ASSERT_TRUE(traced) << traced.error().message.text();
    double lengthMm = 0.0;
    for (const VesselBranch& branch : traced.value().tree.branches) {
        lengthMm += branch.lengthMm();
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            EXPECT_LT(std::hypot(point.y(), point.z()), 2.5) << point.transpose();
            EXPECT_LT(point.x(), 4.0);
        }
    }
    EXPECT_GT(lengthMm, 25.0);
}

TEST(TraceTubes, HearsAStop)
{
    const auto stopped =
        traceTubes(heart().volume, fromOrigins(heart()), [](const TracingReport&) { return ObserverDecision::Stop; });
    EXPECT_TRUE(stopped.isStopped());
}

}   // namespace
