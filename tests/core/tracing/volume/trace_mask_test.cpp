#include "core/tracing/volume/trace_vessels.h"
#include "tests/support/drawn_tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

using namespace angiopose;

namespace {

using core::TracedVessels;
using core::traceMask;
using core::VesselBranch;
using test::Tube;

const core::VolumeGeometry& smallGrid()
{
    static const core::VolumeGeometry grid = test::gridAround({30.0, -40.0, 500.0}, {48, 44, 60}, {0.8, 0.8, 1.0});
    return grid;
}

Eigen::Vector3d place(double x, double y, double z)
{
    return Eigen::Vector3d(30.0, -40.0, 500.0) + Eigen::Vector3d(x, y, z);
}

std::vector<Tube> yShape()
{
    return {{place(0, 0, -25), place(0, 0, 2), 3.2},
            {place(0, 0, 2), place(11, 2, 24), 2.4},
            {place(0, 0, 2), place(-10, -3, 22), 1.8}};
}

TracedVessels tracedMask(const std::vector<Tube>& tubes, const core::VesselTracingOptions& options = {})
{
    auto traced = traceMask(test::drawnMask(smallGrid(), tubes), options);
    EXPECT_TRUE(traced) << (traced ? "" : traced.error().message.text());
    return traced ? std::move(traced).value() : TracedVessels{};
}

double meanRadius(const VesselBranch& branch)
{
    return std::accumulate(branch.radiusMm.begin(), branch.radiusMm.end(), 0.0) /
           static_cast<double>(branch.radiusMm.size());
}

/// Largest distance of the branch's points from the tube's axis, mm.
double offAxis(const VesselBranch& branch, const Tube& tube)
{
    double largest = 0.0;
    for (const Eigen::Vector3d& point : branch.pointsInPatient) {
        largest = std::max(largest, test::distanceToWall({tube}, point) + tube.radiusMm);
    }
    return largest;
}

TEST(TraceVesselMask, FindsTheAxisAndRadiusOfATube)
{
    const Tube tube{place(-9, -6, -22), place(7, 9, 20), 3.0};
    const TracedVessels traced = tracedMask({tube});
    ASSERT_EQ(traced.tree.branches.size(), 1U);
    const VesselBranch& branch = traced.tree.branches.front();
    EXPECT_EQ(branch.generation, 0);
    EXPECT_EQ(branch.id, 1);
    EXPECT_LT(offAxis(branch, tube), 0.55);
    EXPECT_NEAR(meanRadius(branch), 3.0, 0.15);
    EXPECT_NEAR(branch.lengthMm(), (tube.toMm - tube.fromMm).norm(), 3.0);
    EXPECT_FALSE(core::findProblem(traced.tree));
}

TEST(TraceVesselMask, StaysWithinSharpDeformation)
{
    // A wide vessel that continues as a thin hairpin: the curve is smooth but must not leave the lumen.
    const std::vector<Tube> tubes{{place(-8, 0, -40), place(-8, 0, 0), 8.0},
                                  {place(-8, 0, 0), place(-8, 0, 20), 1.2},
                                  {place(-8, 0, 20), place(-3, 0, 20), 1.2},
                                  {place(-3, 0, 20), place(-3, 0, 13), 1.2},
                                  {place(-3, 0, 13), place(12, 0, 13), 1.2}};
    const TracedVessels traced = tracedMask(tubes);
    double outsideMm = 0.0;
    double lengthMm = 0.0;
    for (const VesselBranch& branch : core::resampled(traced.tree, 0.25).branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            lengthMm += 0.25;
            outsideMm += test::distanceToWall(tubes, point) > 0.4 ? 0.25 : 0.0;
        }
    }
    EXPECT_GT(lengthMm, 60.0);
    EXPECT_LT(outsideMm, 1.0);
}

TEST(TraceVesselMask, FollowsAVesselToTheRimThatCutsIt)
{
    const Tube tube{place(0, 0, -60), place(1, 2, 60), 5.0};
    const TracedVessels traced = tracedMask({tube});
    ASSERT_EQ(traced.tree.branches.size(), 1U);
    EXPECT_GT(traced.tree.branches.front().lengthMm(), 57.0);
    EXPECT_NEAR(meanRadius(traced.tree.branches.front()), 5.0, 0.2);
}

TEST(TraceVesselMask, MeasuresTaperingVessels)
{
    const Tube tube{place(0, 0, -26), place(3, 4, 26), 5.0, 1.5};
    const TracedVessels traced = tracedMask({tube}, {.rootInPatient = tube.toMm});
    ASSERT_EQ(traced.tree.branches.size(), 1U);
    const std::vector<double>& radii = traced.tree.branches.front().radiusMm;
    EXPECT_NEAR(radii.front(), 1.5, 0.3);
    EXPECT_NEAR(radii[radii.size() / 2], 3.25, 0.3);
    EXPECT_LT(radii[radii.size() / 4], radii[radii.size() / 2]);
    EXPECT_LT(radii[radii.size() / 2], radii[3 * radii.size() / 4]);
}

TEST(TraceVesselMask, LetsTheTrunkGoOnAndTheThinnerBranchLeaveIt)
{
    const TracedVessels traced = tracedMask(yShape());
    ASSERT_EQ(traced.tree.branches.size(), 2U);
    const VesselBranch& trunk = traced.tree.branches[0];
    const VesselBranch& side = traced.tree.branches[1];
    EXPECT_EQ(trunk.generation, 0);
    EXPECT_EQ(side.generation, 1);
    EXPECT_LT((trunk.pointsInPatient.front() - place(0, 0, -25)).norm(), 2.5);
    EXPECT_LT((trunk.pointsInPatient.back() - place(11, 2, 24)).norm(), 2.0);
    EXPECT_LT((side.pointsInPatient.back() - place(-10, -3, 22)).norm(), 2.0);
    EXPECT_NEAR(side.radiusMm.back(), 1.8, 0.25);
    const auto nodes = core::findNodes(traced.tree);
    EXPECT_EQ(std::count_if(nodes.begin(), nodes.end(), [](const auto& node) { return node.isBifurcation(); }), 1);
}

TEST(TraceVesselMask, BeginsAtTheAskedRoot)
{
    const TracedVessels traced = tracedMask(yShape(), {.rootInPatient = place(-12, -3, 24)});
    ASSERT_EQ(traced.tree.branches.size(), 2U);
    EXPECT_LT((traced.tree.branches[0].pointsInPatient.front() - place(-10, -3, 22)).norm(), 2.0);
}

TEST(TraceVesselMask, LeavesOutShortSpursAndThinBranches)
{
    std::vector<Tube> tubes = yShape();
    tubes.push_back({place(0, 0, -12), place(6, 0, -12), 1.2});   // 3 mm with a tip beyond the wall
    EXPECT_EQ(tracedMask(tubes).tree.branches.size(), 2U);
    EXPECT_EQ(tracedMask(tubes, {.minBranchLengthMm = 2.0}).tree.branches.size(), 3U);
    EXPECT_EQ(tracedMask(tubes, {.minBranchRadiusMm = 2.2}).tree.branches.size(), 1U);
}

TEST(TraceVesselMask, OpensARingOnceAndSaysSo)
{
    std::vector<Tube> ring;
    const double turn = 6.283185307179586 / 40.0;
    for (int n = 0; n < 40; ++n) {
        ring.push_back({place(14 * std::cos(turn * n), 14 * std::sin(turn * n), 0),
                        place(14 * std::cos(turn * (n + 1)), 14 * std::sin(turn * (n + 1)), 0), 2.0});
    }
    const TracedVessels traced = tracedMask(ring);
    ASSERT_EQ(traced.tree.branches.size(), 1U);
    EXPECT_GT(traced.tree.branches.front().lengthMm(), 75.0);
    ASSERT_EQ(traced.warnings.size(), 1U);
    EXPECT_NE(traced.warnings.front().text().find("1 loop was cut"), std::string::npos);
}

TEST(TraceVesselMask, KeepsVesselsThatTouchApartAlongTheirWay)
{
    const std::vector<Tube> tubes{{place(-14, 0, -20), place(14, 0, 20), 3.0},
                                  {place(14, 5.5, -20), place(-14, 5.5, 20), 3.0}};
    const TracedVessels traced = tracedMask(tubes);
    EXPECT_GE(traced.tree.branches.size(), 2U);
    EXPECT_LE(traced.tree.branches.size(), 3U);
    int free = 0;
    for (const Eigen::Vector3d& end : {tubes[0].fromMm, tubes[0].toMm, tubes[1].fromMm, tubes[1].toMm}) {
        for (const VesselBranch& branch : traced.tree.branches) {
            free += (branch.pointsInPatient.front() - end).norm() < 2.5 ||
                    (branch.pointsInPatient.back() - end).norm() < 2.5;
        }
    }
    EXPECT_EQ(free, 4);
}

TEST(TraceVesselMask, FillsHolesInsideTheLumen)
{
    core::VoxelMask mask = test::drawnMask(smallGrid(), {{place(0, 0, -25), place(0, 0, 25), 4.0}});
    for (int k = 12; k < 50; k += 5) {
        mask.at(24, 22, k) = 0;
    }
    const auto traced = traceMask(mask);
    ASSERT_TRUE(traced);
    EXPECT_EQ(traced.value().tree.branches.size(), 1U);
    EXPECT_TRUE(traced.value().warnings.empty());
}

TEST(TraceVesselMask, TakesThePiecesThatHoldSeeds)
{
    const std::vector<Tube> tubes{{place(-12, 0, -20), place(-12, 0, 20), 4.0},
                                  {place(10, 0, -15), place(10, 0, 15), 2.0}};
    EXPECT_EQ(tracedMask(tubes).warnings.size(), 1U);
    const TracedVessels one = tracedMask(tubes, {.seedsInPatient = {place(10, 0, 3)}});
    ASSERT_EQ(one.tree.branches.size(), 1U);
    EXPECT_NEAR(meanRadius(one.tree.branches.front()), 2.0, 0.2);
    const TracedVessels both = tracedMask(tubes, {.seedsInPatient = {place(10, 0, 3), place(-12, 1, 3)}});
    EXPECT_EQ(both.tree.branches.size(), 2U);
    EXPECT_TRUE(both.warnings.empty());
    const auto none = traceMask(test::drawnMask(smallGrid(), tubes), {.seedsInPatient = {place(0, 14, 0)}});
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.text().find("(30.0, -26.0, 500.0)"), std::string::npos);
}

TEST(TraceVesselMask, RefusesWhatHoldsNoVessel)
{
    EXPECT_FALSE(traceMask(core::VoxelMask{}));
    core::VoxelMask mask(smallGrid());
    EXPECT_FALSE(traceMask(mask));
    mask.at(20, 20, 20) = 1;
    EXPECT_FALSE(traceMask(mask));
    mask.geometry.spacingMm.x() = 0.0;
    EXPECT_FALSE(traceMask(mask));
}

TEST(TraceVesselMask, AnswersWhenEverythingIsSet)
{
    const auto traced = traceMask(core::VoxelMask(smallGrid(), 1));
    if (traced) {
        EXPECT_FALSE(core::findProblem(traced.value().tree));
    }
}

TEST(TraceVesselMask, GivesTheSameTreeInAll48AxisOrders)
{
    const core::VolumeGeometry grid = test::gridAround({30.0, -40.0, 500.0}, {40, 36, 54}, {0.8, 0.9, 1.0});
    const auto reference = traceMask(test::drawnMask(grid, yShape()));
    ASSERT_TRUE(reference);
    std::array<int, 3> order{0, 1, 2};
    do {
        for (unsigned flips = 0; flips < 8; ++flips) {
            const core::VolumeGeometry stored =
                test::restored(grid, order, {(flips & 1U) != 0, (flips & 2U) != 0, (flips & 4U) != 0});
            const core::VoxelMask mask = test::drawnMask(stored, yShape());
            const auto traced = traceMask(mask);
            ASSERT_TRUE(traced);
            ASSERT_EQ(traced.value().tree.branches.size(), reference.value().tree.branches.size());
            for (std::size_t b = 0; b < traced.value().tree.branches.size(); ++b) {
                const VesselBranch& found = traced.value().tree.branches[b];
                const VesselBranch& expected = reference.value().tree.branches[b];
                ASSERT_EQ(found.pointsInPatient.size(), expected.pointsInPatient.size());
                for (std::size_t i = 0; i < found.pointsInPatient.size(); ++i) {
                    ASSERT_LT((found.pointsInPatient[i] - expected.pointsInPatient[i]).norm(), 1e-6);
                    ASSERT_NEAR(found.radiusMm[i], expected.radiusMm[i], 1e-6);
                }
            }
            EXPECT_EQ(traced.value().lumen.voxels, mask.voxels);
        }
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(TraceVesselMask, TellsProgressAndKeepsNothingWhenStopped)
{
    const core::VoxelMask mask = test::drawnMask(smallGrid(), yShape());
    double last = -1.0;
    const auto traced = traceMask(mask, {}, [&](const core::TracingReport& report) {
        EXPECT_GE(report.progress, last);
        EXPECT_FALSE(report.stage.empty());
        last = report.progress;
        return core::ObserverDecision::Continue;
    });
    EXPECT_TRUE(traced);
    for (const std::string_view stage : {"vessels", "thinning", "branches"}) {
        const auto stopped = traceMask(mask, {}, [&](const core::TracingReport& report) {
            return report.stage == stage ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
        });
        ASSERT_FALSE(stopped) << stage;
        EXPECT_TRUE(stopped.isStopped());
    }
}

TEST(TraceVesselMask, IsTheSameForAnyNumberOfThreads)
{
    const core::VoxelMask mask = test::drawnMask(smallGrid(), yShape());
    const auto one = traceMask(mask, {.threads = 1});
    const auto three = traceMask(mask, {.threads = 3});
    ASSERT_TRUE(one && three);
    ASSERT_EQ(one.value().tree.branches.size(), three.value().tree.branches.size());
    for (std::size_t b = 0; b < one.value().tree.branches.size(); ++b) {
        EXPECT_EQ(one.value().tree.branches[b].pointsInPatient, three.value().tree.branches[b].pointsInPatient);
        EXPECT_EQ(one.value().tree.branches[b].radiusMm, three.value().tree.branches[b].radiusMm);
    }
}

TEST(TraceLabels, TakesTheAskedLabels)
{
    core::LabelVolume image(smallGrid());
    const core::VoxelMask first = test::drawnMask(smallGrid(), {{place(0, 0, -25), place(0, 0, 25), 3.0}});
    const core::VoxelMask second = test::drawnMask(smallGrid(), {{place(0, 0, 0), place(14, 0, 12), 2.0}});
    for (std::size_t v = 0; v < image.voxels.size(); ++v) {
        image.voxels[v] = first.voxels[v] != 0 ? 7 : second.voxels[v] != 0 ? 300 : 0;
    }
    const auto all = core::traceLabels(image, {});
    const auto one = core::traceLabels(image, {7});
    ASSERT_TRUE(all && one);
    EXPECT_EQ(all.value().tree.branches.size(), 2U);
    EXPECT_EQ(one.value().tree.branches.size(), 1U);
    EXPECT_FALSE(core::traceLabels(image, {5}));
}

}   // namespace
