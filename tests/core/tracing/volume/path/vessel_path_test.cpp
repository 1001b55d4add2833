#include "core/tracing/volume/path/vessel_path.h"

#include "core/messages/messages.h"
#include "core/simulation/simulate_cta.h"
#include "core/support/random.h"
#include "tests/support/tree_agreement.h"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>
#include <numbers>

using namespace angiopose;

namespace {

using namespace core;

constexpr double tissueHu = 60.0;
constexpr double bloodHu = 360.0;

/// Signed distance of a point inside a vessel, mm; negative outside.
using Depth = std::function<double(const Eigen::Vector3d& place)>;

/// 80 × 80 × 60 voxels of 0.6 mm around the origin, blurred by partial volume, with noise.
Volume scanOf(const Depth& depth, const std::function<double(const Eigen::Vector3d&)>& bloodAt, double noiseHu = 15.0)
{
    VolumeGeometry grid;
    grid.size = {80, 80, 60};
    grid.spacingMm = Eigen::Vector3d::Constant(0.6);
    grid.originInPatient = {-23.7, -23.7, -17.7};
    Volume volume(grid);
    CounterRandom random(5);
    for (std::size_t n = 0; n < volume.voxels.size(); ++n) {
        const Eigen::Vector3d place = grid.patientFromVoxel() * grid.voxelAt(n).cast<double>();
        const double share = std::clamp(0.5 + depth(place) / 0.9, 0.0, 1.0);
        volume.voxels[n] = static_cast<std::int16_t>(
            std::lround(tissueHu + share * (bloodAt(place) - tissueHu) + noiseHu * random.normal()));
    }
    return volume;
}

double evenBlood(const Eigen::Vector3d&)
{
    return bloodHu;
}

/// Depth inside a semicircular vessel of radius 15 mm about the origin, in z = 0 from −x over +y to +x, 1.5 mm wide.
double insideArc(const Eigen::Vector3d& place)
{
    const double inPlane = std::hypot(place.x(), place.y());
    const double toArc = place.y() >= 0.0 ? std::hypot(inPlane - 15.0, place.z())
                                          : std::hypot(std::abs(place.x()) - 15.0, place.y(), place.z());
    return 1.5 - toArc;
}

VesselTree arcTree()
{
    VesselTree tree;
    VesselBranch branch{1, "", {}, {}, 0};
    for (int n = 0; n <= 60; ++n) {
        const double angle = std::numbers::pi * (1.0 - n / 60.0);
        branch.pointsInPatient.emplace_back(15.0 * std::cos(angle), 15.0 * std::sin(angle), 0.0);
        branch.radiusMm.push_back(1.5);
    }
    tree.branches.push_back(std::move(branch));
    return tree;
}

const Eigen::Vector3d arcStart(-15.0, 0.0, 0.0);
const Eigen::Vector3d arcEnd(15.0, 0.0, 0.0);

test::TreeAgreement agreementWithArc(const VesselPath& path)
{
    VesselTree tree;
    tree.branches.push_back(path.branch);
    return test::agreementOf(tree, arcTree(), 0.6);
}

TEST(VesselPath, FollowsABentVesselAndMeasuresIt)
{
    const auto path = traceVesselBetween(scanOf(insideArc, evenBlood), arcStart, arcEnd);
    ASSERT_TRUE(path) << path.error().message.text();
    const auto agreement = agreementWithArc(path.value());
    EXPECT_GT(agreement.overlap, 0.97);
    EXPECT_LT(agreement.meanDistanceMm, 0.2);
    EXPECT_LT(agreement.radiusError, 0.1);
    EXPECT_TRUE(path.value().warnings.empty());
}

/// A coronary branch around an opacified ventricle: the straight path through the chamber is shorter.
TEST(VesselPath, DoesNotCutThroughAFilledChamber)
{
    const Depth heart = [](const Eigen::Vector3d& place) { return std::max(insideArc(place), 12.0 - place.norm()); };
    const auto path = traceVesselBetween(scanOf(heart, evenBlood), arcStart, arcEnd);
    ASSERT_TRUE(path) << path.error().message.text();
    EXPECT_GT(agreementWithArc(path.value()).overlap, 0.95);
}

/// Brightness falls along the vessel, as with the coil sensitivity in MR.
TEST(VesselPath, FollowsAVesselThatGrowsDim)
{
    const auto fading = [](const Eigen::Vector3d& place) {
        return tissueHu + 300.0 * std::exp(-(place.x() + 15.0) / 15.0);
    };
    const auto path = traceVesselBetween(scanOf(insideArc, fading, 5.0), arcStart, arcEnd);
    ASSERT_TRUE(path) << path.error().message.text();
    EXPECT_GT(agreementWithArc(path.value()).overlap, 0.95);
}

TEST(VesselPath, TakesClicksBesideTheVessel)
{
    const Eigen::Vector3d beside(0.9, 0.4, 0.9);
    const auto path = traceVesselBetween(scanOf(insideArc, evenBlood), arcStart + beside, arcEnd - beside);
    ASSERT_TRUE(path) << path.error().message.text();
    EXPECT_GT(agreementWithArc(path.value()).overlap, 0.95);
}

/// A path from the middle of an aorta, where everything in view is equally bright, into a branch: more voxels than a
/// single search covers.
TEST(VesselPath, LeavesAWideVesselByAThinOne)
{
    VolumeGeometry grid;
    grid.size = {150, 110, 140};
    grid.spacingMm = Eigen::Vector3d::Constant(0.5);
    grid.originInPatient = {-20.0, -27.0, -35.0};
    Volume scan(grid);
    CounterRandom random(6);
    const auto depth = [](const Eigen::Vector3d& place) {
        const double inAorta = 14.0 - place.head<2>().norm();
        const double inBranch = place.x() > 0.0 ? 1.5 - place.tail<2>().norm() : -1e3;
        return std::max(inAorta, inBranch);
    };
    for (std::size_t n = 0; n < scan.voxels.size(); ++n) {
        const double share =
            std::clamp(0.5 + depth(grid.patientFromVoxel() * grid.voxelAt(n).cast<double>()) / 0.8, 0.0, 1.0);
        scan.voxels[n] = static_cast<std::int16_t>(std::lround(tissueHu + share * 300.0 + 15.0 * random.normal()));
    }
    const auto path = traceVesselBetween(scan, {0.0, 0.0, 24.0}, {50.0, 0.0, 0.0});
    ASSERT_TRUE(path) << path.error().message.text();
    const VesselBranch& branch = path.value().branch;
    EXPECT_NEAR(branch.radiusMm.front(), 14.0, 3.0);
    for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
        EXPECT_GT(depth(branch.pointsInPatient[n]), 0.0);
        if (branch.pointsInPatient[n].x() > 20.0) {
            EXPECT_LT(branch.pointsInPatient[n].tail<2>().norm(), 0.4);
            EXPECT_NEAR(branch.radiusMm[n], 1.5, 0.4);
        }
    }
}

TEST(VesselPath, SaysWhereItRunsThroughNothing)
{
    const Depth interrupted = [](const Eigen::Vector3d& place) {
        return std::abs(place.x()) < 4.0 && place.y() > 0.0 ? -5.0 : insideArc(place);
    };
    const auto path = traceVesselBetween(scanOf(interrupted, evenBlood), arcStart, arcEnd);
    ASSERT_TRUE(path) << path.error().message.text();
    EXPECT_GT(path.value().outsideMm, 5.0);
    ASSERT_EQ(path.value().warnings.size(), 1U);
    EXPECT_TRUE(path.value().warnings.front().is(messages::pathOutside));
}

TEST(VesselPath, RefusesPlacesThatAreNone)
{
    const Volume scan = scanOf(insideArc, evenBlood);
    const auto outside = traceVesselBetween(scan, arcStart, {900.0, 0.0, 0.0});
    ASSERT_FALSE(outside);
    EXPECT_TRUE(outside.error().message.is(messages::pathEndOutsideScan));
    const auto unknown = traceVesselBetween(scan, {std::nan(""), 0.0, 0.0}, arcEnd);
    ASSERT_FALSE(unknown);
    EXPECT_TRUE(unknown.error().message.is(messages::pathEndOutsideScan));
    const auto same = traceVesselBetween(scan, arcStart, arcStart + Eigen::Vector3d(0.1, 0.0, 0.0));
    ASSERT_FALSE(same);
    EXPECT_TRUE(same.error().message.is(messages::pathEndsTooNear));
    const Volume empty(scan.geometry);
    const auto nothing = traceVesselBetween(empty, arcStart, arcEnd);
    ASSERT_FALSE(nothing);
    EXPECT_TRUE(nothing.error().message.is(messages::pathEndOutsideVessel));
}

TEST(VesselPath, HearsAStop)
{
    const auto stopped = traceVesselBetween(scanOf(insideArc, evenBlood), arcStart, arcEnd,
                                            [](const TracingReport&) { return ObserverDecision::Stop; });
    ASSERT_FALSE(stopped);
    EXPECT_TRUE(stopped.isStopped());
}

/// Branches of a simulated body next to bone, calcified plaque and organs.
TEST(VesselPath, TracesEveryBranchOfASimulatedScan)
{
    const SimulatedCta cta = simulateCta(3, {.branchCount = 6, .rootRadiusMm = 6.0},
                                         {.size = {160, 160, 140}, .spacingMm = {0.9, 0.9, 1.0}});
    for (const VesselBranch& branch : cta.tree.branches) {
        const auto path = traceVesselBetween(cta.volume, branch.pointsInPatient.front(),
                                             branch.pointsInPatient[branch.pointsInPatient.size() - 2]);
        ASSERT_TRUE(path) << path.error().message.text();
        VesselTree traced;
        traced.branches.push_back(path.value().branch);
        EXPECT_GT(test::agreementOf(traced, cta.tree, 1.0).right, 0.95) << "branch " << branch.id;
        VesselTree truth;
        truth.branches.push_back(branch);
        EXPECT_GT(test::agreementOf(traced, truth, 1.0).found, 0.9) << "branch " << branch.id;
    }
}

}   // namespace
