#include "core/simulation/simulate_cta.h"
#include "core/tracing/volume/trace_vessels.h"
#include "core/vessel/polyline.h"
#include "tests/support/drawn_tubes.h"
#include "tests/support/for_each.h"
#include "tests/support/tree_agreement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace angiopose;

namespace {

using core::Volume;
using test::distanceTo;
using test::shareNear;
using test::Tube;
using test::tubesInTissue;

const core::SimulatedCta& smallCta()
{
    static const core::SimulatedCta cta =
        core::simulateCta(3, {.branchCount = 6, .rootRadiusMm = 4.0},
                          {.size = {112, 112, 96}, .spacingMm = {1.0, 1.0, 1.0}, .calcificationCount = 4});
    return cta;
}

TEST(TraceVolume, FindsTheVesselsOfASimulatedScanAndNothingElse)
{
    const auto traced = core::traceVessels(smallCta().volume);
    ASSERT_TRUE(traced) << traced.error().message;
    EXPECT_GT(shareNear(smallCta().tree, traced.value().tree, 2.0), 0.93);
    EXPECT_GT(shareNear(traced.value().tree, smallCta().tree, 2.0), 0.95);
    EXPECT_NEAR(traced.value().threshold, 0.5 * (45 + 380), 30.0);
    EXPECT_FALSE(core::findProblem(traced.value().tree));
    EXPECT_EQ(traced.value().lumen.voxels.size(), smallCta().volume.voxels.size());
}

TEST(TraceVolume, IsTheSameForAnyNumberOfThreadsAndAxisOrder)
{
    const Volume& volume = smallCta().volume;
    const auto one = core::traceVessels(volume, {.threads = 1});
    const auto three = core::traceVessels(volume, {.threads = 3});
    ASSERT_TRUE(one && three);
    // Stored as sagittal slices starting at the right, feet first.
    Volume turned(test::restored(volume.geometry, {1, 2, 0}, {true, false, true}));
    const Eigen::Vector3i& size = volume.geometry.size;
    test::forEachVoxel(
        size, [&](int i, int j, int k) { turned.at(size.y() - 1 - j, k, size.x() - 1 - i) = volume.at(i, j, k); });
    const auto other = core::traceVessels(turned);
    ASSERT_TRUE(other);
    ASSERT_EQ(one.value().tree.branches.size(), three.value().tree.branches.size());
    ASSERT_EQ(one.value().tree.branches.size(), other.value().tree.branches.size());
    for (std::size_t b = 0; b < one.value().tree.branches.size(); ++b) {
        const core::VesselBranch& expected = one.value().tree.branches[b];
        EXPECT_EQ(expected.pointsInPatient, three.value().tree.branches[b].pointsInPatient);
        EXPECT_EQ(expected.radiusMm, three.value().tree.branches[b].radiusMm);
        const core::VesselBranch& found = other.value().tree.branches[b];
        ASSERT_EQ(found.pointsInPatient.size(), expected.pointsInPatient.size());
        for (std::size_t n = 0; n < found.pointsInPatient.size(); ++n) {
            EXPECT_LT((found.pointsInPatient[n] - expected.pointsInPatient[n]).norm(), 1e-6);
        }
    }
}

/// The scan as an 8-bit image in a frame of air: 0 at -200 HU and below, 255 at 1300 HU.
Volume asPicture(const Volume& scan, int frame)
{
    core::VolumeGeometry grid = scan.geometry;
    grid.size.array() += 2 * frame;
    grid.originInPatient = scan.geometry.patientFromVoxel() * Eigen::Vector3d::Constant(-frame);
    Volume picture(grid, 0);
    test::forEachVoxel(scan.geometry.size, [&](int i, int j, int k) {
        const double share = (scan.value(scan.geometry.index(i, j, k)) + 200.0) / 1500.0;
        picture.at(i + frame, j + frame, k + frame) =
            static_cast<std::int16_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
    });
    return picture;
}

TEST(TraceVolume, AirAroundAPatientInGrayValuesIsNoTissue)
{
    const core::SimulatedCta cta = core::simulateCta(3, {.branchCount = 6, .rootRadiusMm = 7.0},
                                                     {.size = {112, 112, 96}, .spacingMm = {1.0, 1.0, 1.0}});
    const auto usual = core::traceVessels(cta.volume);
    const auto traced = core::traceVessels(asPicture(cta.volume, 30));
    ASSERT_TRUE(usual && traced) << traced.error().message;
    const double usualThreshold = 255.0 * (usual.value().threshold + 200.0) / 1500.0;
    EXPECT_NEAR(traced.value().threshold, usualThreshold, 4.0);
    EXPECT_GT(shareNear(cta.tree, traced.value().tree, 2.0), 0.9);
    EXPECT_GT(shareNear(traced.value().tree, cta.tree, 2.0), 0.95);
}

TEST(TraceVolume, TakesAGivenThresholdAndSeeds)
{
    const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {48, 40, 60}, {1.0, 1.0, 1.0});
    const Tube wide{{-8, 0, -24}, {-8, 2, 24}, 5.0};
    const Tube thin{{10, 0, -24}, {10, -3, 24}, 3.0};
    const Volume volume = tubesInTissue(grid, {wide, thin});
    const auto chosen = core::traceVessels(volume, {.threshold = 200.0, .seedsInPatient = {{10, -1, 0}}});
    ASSERT_TRUE(chosen) << chosen.error().message;
    EXPECT_EQ(chosen.value().threshold, 200.0);
    ASSERT_EQ(chosen.value().tree.branches.size(), 1U);
    const core::VesselBranch& branch = chosen.value().tree.branches.front();
    EXPECT_NEAR(branch.radiusMm[branch.radiusMm.size() / 2], 3.0, 0.2);
    EXPECT_FALSE(core::traceVessels(volume, {.seedsInPatient = {{0, 15, 0}}}));
}

bool isSame(const core::VesselTree& a, const core::VesselTree& b)
{
    return std::ranges::equal(a.branches, b.branches, [](const core::VesselBranch& one, const core::VesselBranch& two) {
        return one.pointsInPatient == two.pointsInPatient && one.radiusMm == two.radiusMm;
    });
}

TEST(TraceVolume, IsTheSameForSeedsInAnyBranchAndForNone)
{
    const core::SimulatedCta cta =
        core::simulateCta(3, {.branchCount = 6, .rootRadiusMm = 6.0},
                          {.size = {128, 128, 120}, .spacingMm = {1.2, 1.2, 1.2}, .calcificationCount = 4});
    const auto found = core::traceVessels(cta.volume);
    ASSERT_TRUE(found) << found.error().message;
    ASSERT_TRUE(found.value().foundStart);
    EXPECT_LT(distanceTo(cta.tree, *found.value().foundStart), 3.0);
    ASSERT_FALSE(found.value().warnings.empty());
    EXPECT_NE(found.value().warnings.front().text().find("No seed was placed: the aorta"), std::string::npos);
    for (const core::VesselBranch& branch : cta.tree.branches) {
        const Eigen::Vector3d seed = branch.pointsInPatient[branch.pointsInPatient.size() / 2];
        const auto traced = core::traceVessels(cta.volume, {.seedsInPatient = {seed}});
        ASSERT_TRUE(traced) << traced.error().message;
        EXPECT_FALSE(traced.value().foundStart);
        EXPECT_TRUE(isSame(traced.value().tree, found.value().tree)) << "seed in branch " << branch.id;
    }
}

/// An aorta with an artery, in contact with a heart of two chambers; 1.5 mm voxels, 90 x 66 x 135 mm.
Volume aortaAndHeart()
{
    const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {60, 44, 90}, {1.5, 1.5, 1.5});
    return tubesInTissue(grid, {{{-22, 8, -70}, {-22, 8, 70}, 9.0},
                                {{-22, 8, 30}, {-2, -20, 55}, 3.0},
                                {{18, -4, -18}, {22, -4, -26}, 20.0},
                                {{18, 0, 14}, {22, 0, 16}, 16.0},
                                {{-22, 8, -20}, {10, 0, -20}, 2.5}});
}

TEST(TraceVolume, FindsTheAortaBesideAWiderHeart)
{
    const auto found = core::traceVessels(aortaAndHeart());
    ASSERT_TRUE(found) << found.error().message;
    ASSERT_TRUE(found.value().foundStart);
    EXPECT_NEAR(found.value().foundStart->x(), -22.0, 2.0);
    EXPECT_NEAR(found.value().foundStart->y(), 8.0, 2.0);
    const core::VesselTree& tree = found.value().tree;
    EXPECT_LT(distanceTo(tree, {-22, 8, -55}), 1.5);
    EXPECT_LT(distanceTo(tree, {-22, 8, 55}), 1.5);
    EXPECT_LT(distanceTo(tree, {-5, -16, 51}), 2.0);
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            EXPECT_FALSE(point.x() > 5.0 && point.z() < 40.0) << "in the heart: " << point.transpose();
        }
    }
}

TEST(TraceVolume, SeedsBesideAWideVesselAreMeantForIt)
{
    const auto inside = core::traceVessels(aortaAndHeart(), {.seedsInPatient = {{-22, 8, -40}}});
    const auto beside = core::traceVessels(aortaAndHeart(), {.seedsInPatient = {{-22, 21, -40}}});
    ASSERT_TRUE(inside && beside);
    EXPECT_TRUE(isSame(inside.value().tree, beside.value().tree));
    ASSERT_FALSE(beside.value().warnings.empty());
    EXPECT_NE(beside.value().warnings.front().text().find("is not inside an enhanced vessel"), std::string::npos);
    EXPECT_FALSE(core::traceVessels(aortaAndHeart(), {.seedsInPatient = {{-22, 31, -40}}}));
}

TEST(TraceVolume, PartsAtTheNarrowestPlaceFromWhatIsAvoided)
{
    const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {64, 40, 60}, {1.0, 1.0, 1.0});
    const Volume volume = tubesInTissue(
        grid, {{{-9, 0, -25}, {-9, 0, 25}, 5.0}, {{10, 0, -20}, {10, 0, 20}, 8.0}, {{-9, 0, 3}, {10, 0, 3}, 2.0}});
    const auto whole = core::traceVessels(volume, {.seedsInPatient = {{-9, 0, -10}}});
    const auto parted =
        core::traceVessels(volume, {.seedsInPatient = {{-9, 0, -10}}, .avoidInPatient = {{10, 0, -10}}});
    ASSERT_TRUE(whole && parted);
    EXPECT_GT(whole.value().tree.branches.size(), 1U);
    for (const core::VesselBranch& branch : parted.value().tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            EXPECT_LT(point.x(), 4.0);
        }
    }
    EXPECT_FALSE(core::traceVessels(volume, {.avoidInPatient = {{10, 0, -10}}}));
}

TEST(TraceVolume, RefusesWhatShowsNoContrast)
{
    const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {30, 30, 30}, {1.0, 1.0, 1.0});
    EXPECT_FALSE(core::traceVessels(Volume{}));
    EXPECT_FALSE(core::traceVessels(Volume(grid, 40)));
    const auto traced = core::traceVessels(tubesInTissue(grid, {{{90, 0, 0}, {91, 0, 0}, 1.0}}));
    ASSERT_FALSE(traced);
    EXPECT_NE(traced.error().message.text().find("soft tissue measures 53 HU"), std::string::npos)
        << traced.error().message;
    EXPECT_NE(traced.error().message.text().find("arterial phase"), std::string::npos);
}

/// Adds a long bone along z whose uneven marrow is as bright as weak contrast agent.
void addBone(Volume& volume)
{
    const core::VolumeGeometry& grid = volume.geometry;
    const std::vector<Tube> bone{{{6, 0, -26}, {6, 0, 26}, 9.0}};
    test::forEachVoxel(grid.size, [&](int i, int j, int k) {
        const double wall = test::distanceToWall(bone, grid.patientFromVoxel() * Eigen::Vector3d(i, j, k));
        const int marrow = 230 + 80 * ((7 * i + 13 * j + 5 * k) % 3 - 1);
        if (wall < 0.0) {
            volume.at(i, j, k) = static_cast<std::int16_t>(wall > -3.5 ? 900 : marrow);
        }
    });
}

TEST(TraceVolume, NeverTracesBone)
{
    const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {56, 48, 60}, {1.0, 1.0, 1.0});
    Volume bone = tubesInTissue(grid, {{{90, 0, 0}, {91, 0, 0}, 1.0}});
    addBone(bone);
    const auto none = core::traceVessels(bone);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.text().find("soft tissue "), std::string::npos) << none.error().message;
    EXPECT_NE(none.error().message.text().find("arterial phase"), std::string::npos) << none.error().message;
    Volume both = tubesInTissue(grid, {{{-14, 0, -26}, {-14, 2, 26}, 4.0}});
    addBone(both);
    const auto vessel = core::traceVessels(both);
    ASSERT_TRUE(vessel) << vessel.error().message;
    for (const core::VesselBranch& branch : vessel.value().tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            EXPECT_LT(point.x(), -10.0);
        }
    }
}

TEST(TraceVolume, RefusesShellsWithoutBloodOnTheirAxes)
{
    const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {56, 48, 60}, {1.0, 1.0, 1.0});
    const std::vector<Tube> shell{{{0, 0, -10}, {0, 0, 10}, 12.0}};
    Volume volume = tubesInTissue(grid, shell);
    EXPECT_TRUE(core::traceVessels(volume));
    test::forEachVoxel(grid.size, [&](int i, int j, int k) {
        if (test::distanceToWall(shell, grid.patientFromVoxel() * Eigen::Vector3d(i, j, k)) < -6.0) {
            volume.at(i, j, k) = 120;
        }
    });
    const auto traced = core::traceVessels(volume);
    ASSERT_FALSE(traced);
    EXPECT_NE(traced.error().message.text().find("not vessel-like"), std::string::npos) << traced.error().message;
}

TEST(TraceVolume, StopsAtOnceInEachStage)
{
    for (const std::string_view stage : {"blood", "vessels", "thinning", "branches"}) {
        bool isAsked = false;
        int later = 0;
        const auto traced = core::traceVessels(smallCta().volume, {}, [&](const core::TracingReport& report) {
            later += isAsked ? 1 : 0;
            isAsked = isAsked || report.stage == stage;
            return isAsked ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
        });
        ASSERT_FALSE(traced) << stage;
        EXPECT_TRUE(traced.isStopped()) << traced.error().message;
        EXPECT_EQ(later, 0);
    }
}

}   // namespace
