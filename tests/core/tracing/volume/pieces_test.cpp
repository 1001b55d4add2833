#include "core/registration/registration.h"
#include "core/tracing/tree/boundary_stubs.h"
#include "core/tracing/volume/trace_vessels.h"
#include "core/vessel/edit_tree.h"
#include "core/vessel/root_tree.h"
#include "core/vessel/tree_gaps.h"
#include "core/vessel/tree_knots.h"
#include "tests/support/clean_case.h"
#include "tests/support/drawn_tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <numbers>

using namespace angiopose;

namespace {

using core::TracedPieces;
using core::TracedVessels;
using core::VesselLoops;
using test::Tube;

const core::VolumeGeometry& piecesGrid()
{
    static const core::VolumeGeometry grid = test::gridAround({30.0, -40.0, 500.0}, {64, 50, 60}, {0.8, 0.8, 1.0});
    return grid;
}

Eigen::Vector3d at(double x, double y, double z)
{
    return Eigen::Vector3d(30.0, -40.0, 500.0) + Eigen::Vector3d(x, y, z);
}

TracedVessels tracedPieces(const std::vector<Tube>& tubes, const core::VesselTracingOptions& options = {},
                           const core::VolumeGeometry& grid = piecesGrid())
{
    auto traced = core::traceMask(test::drawnMask(grid, tubes), options);
    EXPECT_TRUE(traced) << (traced ? "" : traced.error().message.text());
    return traced ? std::move(traced).value() : TracedVessels{};
}

/// A Y-shaped vessel and a separate thinner one, as the two coronary arteries.
std::vector<Tube> twoRoots()
{
    return {{at(-12, 0, -25), at(-12, 0, 0), 3.0},
            {at(-12, 0, 0), at(-20, 2, 22), 2.0},
            {at(-12, 0, 0), at(-4, 2, 22), 2.0},
            {at(14, 0, -20), at(14, 3, 20), 2.0}};
}

std::ptrdiff_t rootsOf(const core::VesselTree& tree)
{
    return std::ranges::count(tree.branches, 0, &core::VesselBranch::generation);
}

std::string said(const TracedVessels& traced)
{
    std::string all;
    for (const core::Message& warning : traced.warnings) {
        all += warning.text() + "\n";
    }
    return all;
}

TEST(TracedPieces, AreOneForestWithARootEach)
{
    const TracedVessels traced = tracedPieces(twoRoots());
    EXPECT_EQ(traced.tree.branches.size(), 3U);
    EXPECT_EQ(rootsOf(traced.tree), 2);
    EXPECT_EQ(traced.tree.branches[0].generation, 0);
    EXPECT_EQ(traced.tree.branches[2].generation, 0) << "the largest piece with its branches comes first";
    EXPECT_FALSE(core::findProblem(traced.tree));
    ASSERT_EQ(traced.pieces.size(), 2U);
    EXPECT_NEAR(traced.pieces[0].share + traced.pieces[1].share, 1.0, 1e-9);
    EXPECT_NEAR(traced.pieces[1].lengthMm, 40.0, 4.0);
    EXPECT_NE(said(traced).find("2 unconnected components"), std::string::npos) << said(traced);
}

TEST(TracedPieces, TheirPlacesAreSeeds)
{
    const TracedVessels all = tracedPieces(twoRoots());
    ASSERT_EQ(all.pieces.size(), 2U);
    const TracedVessels second = tracedPieces(twoRoots(), {.seedsInPatient = {all.pieces[1].positionInPatient}});
    ASSERT_EQ(second.tree.branches.size(), 1U);
    EXPECT_NEAR(second.tree.branches.front().lengthMm(), all.pieces[1].lengthMm, 0.5);
    EXPECT_NE(said(second).find("was omitted"), std::string::npos) << "the other one is reported";
}

TEST(TracedPieces, TheLargestAloneIsTracedWhereItIsAskedFor)
{
    const TracedVessels traced = tracedPieces(twoRoots(), {.pieces = TracedPieces::Largest});
    EXPECT_EQ(traced.tree.branches.size(), 2U);
    EXPECT_EQ(rootsOf(traced.tree), 1);
    ASSERT_EQ(traced.pieces.size(), 2U);
    EXPECT_FALSE(traced.pieces[1].isTraced());
    EXPECT_NE(said(traced).find("omitted"), std::string::npos);
}

TEST(TracedPieces, ManySmallOnesAreToldOfTogether)
{
    std::vector<Tube> tubes{{at(0, 0, -25), at(0, 0, 25), 3.0}};
    for (int n = 0; n < 6; ++n) {   // spheres of 0.4 % each
        const double x = n % 2 == 0 ? -18.0 : 18.0;
        tubes.push_back({at(x, -12 + 4.0 * n, 0), at(x, -12 + 4.0 * n, 0.1), 1.1});
    }
    const TracedVessels traced = tracedPieces(tubes);
    EXPECT_EQ(traced.tree.branches.size(), 1U);
    EXPECT_NE(said(traced).find("6 components with"), std::string::npos) << said(traced);
    EXPECT_NE(said(traced).find("contain no branch"), std::string::npos);
    tubes.resize(2);
    EXPECT_EQ(said(tracedPieces(tubes)), "") << "a speck below 2 % is not worth a word";
}

TEST(TracedPieces, ManyPiecesAreNamedInPart)
{
    std::vector<Tube> tubes;
    for (int n = 0; n < 12; ++n) {
        const double x = -20.0 + 8.0 * (n % 6);
        const double y = n < 6 ? -10.0 : 10.0;
        tubes.push_back({at(x, y, -15), at(x, y, 15), 1.5});
    }
    const TracedVessels traced = tracedPieces(tubes);
    EXPECT_EQ(rootsOf(traced.tree), 12);
    EXPECT_EQ(traced.pieces.size(), 12U);
    EXPECT_NE(said(traced).find("6 more with 50 %"), std::string::npos) << said(traced);
}

TEST(TracedPieces, AClearGapIsClosed)
{
    const std::vector<Tube> tubes{{at(0, 0, -26), at(0, 0, -3.5), 2.5}, {at(0, 0, 3.5), at(2, 0, 26), 2.5}};
    const TracedVessels traced = tracedPieces(tubes);
    ASSERT_EQ(traced.tree.branches.size(), 1U);
    EXPECT_GT(traced.tree.branches.front().lengthMm(), 50.0);
    EXPECT_NE(said(traced).find("were closed (number: 1"), std::string::npos) << said(traced);
    EXPECT_EQ(core::componentCount(traced.tree), 1);
    const TracedVessels one = tracedPieces(tubes, {.pieces = TracedPieces::Largest});
    EXPECT_LT(one.tree.branches.front().lengthMm(), 30.0);
}

TEST(TracedPieces, GapsThatAreNotClearStay)
{
    // Parallel vessels, distant ones, and a wide vessel in front of a thin one.
    const std::vector<std::vector<Tube>> scenes{{{at(0, 0, -26), at(0, 0, 0), 2.0}, {at(7, 0, 0), at(7, 0, 26), 2.0}},
                                                {{at(0, 0, -28), at(0, 0, -12), 1.5}, {at(0, 0, 8), at(0, 0, 28), 1.5}},
                                                {{at(0, 0, -26), at(0, 0, -5), 5.0}, {at(0, 0, 4), at(0, 0, 26), 1.2}}};
    for (const std::vector<Tube>& tubes : scenes) {
        EXPECT_EQ(rootsOf(tracedPieces(tubes).tree), 2);
    }
}

/// A ring with one vessel leading to it and two leaving it.
std::vector<Tube> circleOfWillis()
{
    std::vector<Tube> tubes{{at(-26, 0, 0), at(-14, 0, 0), 2.0},
                            {at(9.9, 9.9, 0), at(20, 17, 5), 1.6},
                            {at(9.9, -9.9, 0), at(20, -17, 5), 1.6}};
    const double turn = 2.0 * std::numbers::pi / 40.0;
    for (int n = 0; n < 40; ++n) {
        tubes.push_back({at(14 * std::cos(turn * n), 14 * std::sin(turn * n), 0),
                         at(14 * std::cos(turn * (n + 1)), 14 * std::sin(turn * (n + 1)), 0), 1.8});
    }
    return tubes;
}

TEST(TracedLoops, AreKeptWhereAsked)
{
    const TracedVessels opened = tracedPieces(circleOfWillis());
    const TracedVessels kept = tracedPieces(circleOfWillis(), {.loops = VesselLoops::Kept});
    EXPECT_NE(said(opened).find("1 loop was cut"), std::string::npos);
    EXPECT_NE(said(kept).find("Loops kept as requested: 1"), std::string::npos) << said(kept);
    const std::vector<core::VesselNode> nodes = core::findNodes(kept.tree);
    EXPECT_EQ(std::ranges::count_if(nodes, [](const core::VesselNode& node) { return !node.isBifurcation(); }), 3)
        << "where blood comes in, and where it leaves";
    EXPECT_EQ(core::treeKnots(kept.tree, {}, 2.0).cuts.size(), 1U) << "one cut makes it a tree";
    EXPECT_EQ(core::componentCount(kept.tree), 1);
    EXPECT_EQ(rootsOf(kept.tree), 1);
}

TEST(TracedLoops, ARingAloneIsClosed)
{
    std::vector<Tube> ring = circleOfWillis();
    ring.erase(ring.begin(), ring.begin() + 3);
    const TracedVessels kept = tracedPieces(ring, {.loops = VesselLoops::Kept});
    ASSERT_EQ(kept.tree.branches.size(), 1U);
    const auto& points = kept.tree.branches.front().pointsInPatient;
    EXPECT_LT((points.front() - points.back()).norm(), 0.5);
    EXPECT_NEAR(kept.tree.branches.front().lengthMm(), 2.0 * std::numbers::pi * 14.0, 5.0);
}

TEST(TracedLoops, FlawsOfTheLumenAreOpenedAllTheSame)
{
    core::VoxelMask mask = test::drawnMask(piecesGrid(), {{at(0, 0, -25), at(0, 0, 25), 5.0}});
    for (int i = 0; i < 64; ++i) {   // a gap across the vessel
        mask.at(i, 25, 30) = 0;
        mask.at(i, 24, 30) = 0;
    }
    const auto traced = core::traceMask(mask, {.loops = VesselLoops::Kept});
    ASSERT_TRUE(traced);
    EXPECT_EQ(said(traced.value()).find("kept"), std::string::npos);
    EXPECT_TRUE(core::treeKnots(traced.value().tree, {}, 2.0).cuts.empty());
}

TEST(ForestOfVessels, IsEditedPieceByPiece)
{
    const core::VesselTree tree = tracedPieces(twoRoots()).tree;
    ASSERT_EQ(tree.branches.size(), 3U);
    const auto without = core::removeSubtree(tree, tree.branches[0].id);
    ASSERT_TRUE(without);
    ASSERT_EQ(without.value().branches.size(), 1U) << "the other piece stays";
    EXPECT_EQ(without.value().branches[0].id, tree.branches[2].id);
    const auto prunedTree = core::pruneTree(tree, 5.0, 0.0);
    ASSERT_TRUE(prunedTree);
    EXPECT_EQ(prunedTree.value().branches.size(), 3U);
    const core::VesselTree rooted = core::rootTreeAt(tree, at(14, 3, 20));
    EXPECT_EQ(rootsOf(rooted), 2) << "a new root of the one piece, one of the other";
    EXPECT_LT((rooted.branches.front().pointsInPatient.front() - at(14, 3, 20)).norm(), 3.0);
    const auto cut = core::splitAt(tree, tree.branches[2].id, 15);
    ASSERT_TRUE(cut);
    EXPECT_EQ(core::componentCount(cut.value()), 2) << "the halves still touch";
}

TEST(ForestOfVessels, IsRegisteredAsOne)
{
    test::CleanCase clean(2);
    core::VesselTree second = core::simulateTree(9, {.branchCount = 8, .extentMm = 70.0, .rootRadiusMm = 2.0});
    for (core::VesselBranch& branch : second.branches) {
        branch.id += 1000;
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            point += Eigen::Vector3d(110.0, 20.0, 40.0);
        }
        clean.tree.branches.push_back(branch);
    }
    ASSERT_EQ(core::componentCount(clean.tree), 2);
    clean.target = core::projectTree(clean.tree, clean.camera, clean.truth);
    const auto result = core::registerVessels(clean.fromNearby(2));
    ASSERT_TRUE(result);
    EXPECT_LT(meanErrorPx(clean, result.value().cameraFromPatient), 0.1);
    EXPECT_TRUE(result.value().trustworthy);
}

/// A vessel of 5 mm radius along z and a branch along x that reaches the border of the grid.
TEST(RimStub, IsABulgeThatACropCutsOff)
{
    core::VolumeGeometry grid;
    grid.size = {30, 30, 40};
    core::VoxelMask lumen(grid, 1);
    core::VesselCurve parent;
    for (int z = 0; z < 40; ++z) {
        parent.pointsMm.emplace_back(21.0, 15.0, z);
        parent.radiusMm.push_back(5.0);
    }
    const auto leavingFrom = [&](double x) {
        core::VesselCurve curve;
        for (Eigen::Vector3d& point : parent.pointsMm) {
            point.x() = x;
        }
        for (double at = x; at <= 29.0; at += 1.0) {
            curve.pointsMm.emplace_back(at, 15.0, 20.0);
            curve.radiusMm.push_back(2.0);
        }
        return curve;
    };
    EXPECT_TRUE(core::isBoundaryStub(leavingFrom(21.0), parent, lumen, 4.0)) << "3 mm beyond the wall";
    EXPECT_FALSE(core::isBoundaryStub(leavingFrom(10.0), parent, lumen, 4.0)) << "14 mm beyond the wall";
    const core::VesselCurve bulge = leavingFrom(21.0);
    for (int k = 0; k < 40; ++k) {
        for (int j = 0; j < 30; ++j) {
            lumen.at(29, j, k) = 0;
        }
    }
    EXPECT_FALSE(core::isBoundaryStub(bulge, parent, lumen, 4.0)) << "not cut off: pruning judges it";
}

TEST(TracedPieces, ACropAcrossAVesselLeavesNoStubs)
{
    const core::VolumeGeometry grid = test::gridAround({30.0, -40.0, 500.0}, {60, 60, 50}, {0.8, 0.8, 0.8});
    for (const double radiusMm : {3.0, 6.0}) {
        for (const double degrees : {0.0, 30.0, 50.0, 65.0}) {
            const double angle = degrees * std::numbers::pi / 180.0;
            const Eigen::Vector3d way(60.0 * std::sin(angle), 0.0, 60.0 * std::cos(angle));
            const TracedVessels traced = tracedPieces(
                {{Eigen::Vector3d(at(0, 0, -10) - way), Eigen::Vector3d(at(0, 0, -10) + way), radiusMm}}, {}, grid);
            EXPECT_EQ(traced.tree.branches.size(), 1U) << radiusMm << " mm, " << degrees << " degrees";
        }
    }
}

/// Random noise in every fifth voxel: no vessels, but the worst case for component, skeleton and graph processing.
core::VoxelMask noise()
{
    core::VoxelMask mask(test::gridAround({0.0, 0.0, 0.0}, {120, 120, 120}, {1.0, 1.0, 1.0}));
    std::uint32_t bits = 12345;
    for (std::uint8_t& voxel : mask.voxels) {
        bits = bits * 1664525U + 1013904223U;
        voxel = (bits >> 16U) % 100U < 22U ? 1 : 0;
    }
    return mask;
}

TEST(TracedPieces, OfNoiseEndWhenStopped)
{
    const core::VoxelMask mask = noise();
    for (const int heardAfter : {1, 3, 10}) {
        int reports = 0;
        auto stoppedAt = std::chrono::steady_clock::now();
        const auto traced = core::traceMask(mask, {}, [&](const core::TracingReport&) {
            const bool isCancellation = ++reports >= heardAfter;
            stoppedAt = isCancellation ? std::chrono::steady_clock::now() : stoppedAt;
            return isCancellation ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
        });
        ASSERT_FALSE(traced);
        EXPECT_TRUE(traced.error().isCancellation());
        EXPECT_EQ(reports, heardAfter) << "once stopped, nothing is asked again";
        RecordProperty("stopMs" + std::to_string(heardAfter),
                       static_cast<int>(std::chrono::duration_cast<std::chrono::milliseconds>(
                                            std::chrono::steady_clock::now() - stoppedAt)
                                            .count()));
    }
}

}   // namespace
