#include "core/tracing/tree/dim_subtrees.h"

#include "core/tracing/volume/trace_vessels.h"
#include "tests/support/drawn_tubes.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace angiopose;

namespace {

using test::Tube;

/// An opacified vessel; where two overlap, the later one counts.
struct Vessel {
    Tube tube;
    double fill = 1.0;
};

core::PointOpacification fillOf(const std::vector<Vessel>& vessels)
{
    return [vessels](const Eigen::Vector3d& pointMm) {
        double fill = 0.0;
        for (const Vessel& vessel : vessels) {
            const double share = std::clamp(0.5 - test::distanceToWall({vessel.tube}, pointMm), 0.0, 1.0);
            fill = share > 0.0 ? std::max(fill * (1.0 - share), share * vessel.fill) : fill;
        }
        return fill;
    };
}

core::VesselEdge edgeIn(const Tube& tube, int startNode, int endNode)
{
    core::VesselEdge edge{startNode, endNode, {}, {}};
    const double lengthMm = (tube.toMm - tube.fromMm).norm();
    for (double along = 0.0; along <= lengthMm; along += 1.0) {
        edge.pointsMm.emplace_back(tube.fromMm + along / lengthMm * (tube.toMm - tube.fromMm));
        edge.radiusMm.push_back(tube.radiusMm);
    }
    return edge;
}

/// A trunk along z, an artery from it, `something` at the end of the artery, and `beyond` after that.
class LeakingTree {
public:
    LeakingTree(const Vessel& something, const Vessel& beyond)
        : fill_(fillOf({{upper_, 1.0}, {lower_, 1.0}, {artery_, 1.0}, something, beyond}))
    {
        graph_.nodesMm = {upper_.fromMm, upper_.toMm, lower_.toMm, artery_.toMm, something.tube.toMm, beyond.tube.toMm};
        graph_.nodeRadiusMm.assign(6, 3.0);
        graph_.edges = {edgeIn(upper_, 0, 1), edgeIn(lower_, 1, 2), edgeIn(artery_, 1, 3), edgeIn(something.tube, 3, 4),
                        edgeIn(beyond.tube, 4, 5)};
    }

    /// Number of the five edges that are kept.
    std::size_t left(const std::vector<Eigen::Vector3d>& startsMm = {{0, 0, 20}, {0, 0, 80}})
    {
        const int removed = core::removeDimSubtrees(graph_, fill_, startsMm, 1.0);
        EXPECT_EQ(removed > 0, graph_.edges.size() < 5U);
        return graph_.edges.size();
    }

private:
    Tube upper_{{0, 0, 0}, {0, 0, 50}, 6.0};
    Tube lower_{{0, 0, 50}, {0, 0, 100}, 6.0};
    Tube artery_{{0, 0, 50}, {50, 0, 50}, 3.0};
    core::PointOpacification fill_;
    core::VesselGraph graph_;
};

Vessel goingOn(double fill, double radiusMm = 3.5)
{
    return {{{50, 0, 50}, {80, 0, 50}, radiusMm}, fill};
}

Vessel atTheEnd(double fill, double radiusMm, double lengthMm = 20.0)
{
    return {{{80, 0, 50}, {80, lengthMm, 50}, radiusMm}, fill};
}

TEST(DropDimParts, LeavesOutAVeinAndWhatLiesBeyondIt)
{
    EXPECT_EQ(LeakingTree(goingOn(0.55), atTheEnd(0.55, 3.0)).left(), 3U);
    EXPECT_EQ(LeakingTree(goingOn(0.55), atTheEnd(0.4, 0.8)).left(), 3U);   // too thin to measure its brightness
}

TEST(DropDimParts, KeepsWhatIsFilledOrTooThinToTell)
{
    EXPECT_EQ(LeakingTree(goingOn(0.85), atTheEnd(0.85, 3.0)).left(), 5U);
    EXPECT_EQ(LeakingTree(goingOn(0.55, 0.9), atTheEnd(0.4, 0.8)).left(), 5U);
}

TEST(DropDimParts, KeepsWhatLeadsToMoreFilledVessels)
{
    EXPECT_EQ(LeakingTree(goingOn(0.55), atTheEnd(1.0, 3.0, 60.0)).left(), 5U);
}

TEST(DropDimParts, KeepsWhatHoldsAStartOrLiesBesideOne)
{
    const std::vector<Eigen::Vector3d> starts{{0, 0, 20}, {0, 0, 80}, {80, 15, 50}};
    EXPECT_EQ(LeakingTree(goingOn(0.55), atTheEnd(0.55, 3.0)).left(starts), 5U);
    const Vessel falseLumen{{{50, 0, 50}, {10, 5, 50}, 3.5}, 0.55};
    EXPECT_EQ(LeakingTree(falseLumen, {{{10, 5, 50}, {10, 15, 50}, 3.0}, 0.55}).left({{0, 0, 40}, {10, 0, 55}}), 5U);
    EXPECT_EQ(LeakingTree(goingOn(0.55), atTheEnd(0.55, 3.0)).left({}), 5U);
}

TEST(DropDimParts, LeavesTheVeinOutOfATracedScan)
{
    const std::vector<Vessel> vessels{{{{-25, 0, -60}, {-25, 0, 60}, 8.0}, 1.0},
                                      {{{-25, 0, -20}, {50, 0, -20}, 2.5}, 1.0},
                                      {{{25, 0, -16}, {25, 0, 45}, 3.5}, 0.58}};
    const core::PointOpacification fill = fillOf(vessels);
    const core::VolumeGeometry grid = test::gridAround({10, 0, 0}, {120, 60, 110}, {1.0, 1.0, 1.0});
    core::Volume scan(grid);
    test::forEachVoxel(grid.size, [&](int i, int j, int k) {
        const double share = fill(grid.patientFromVoxel() * Eigen::Vector3d(i, j, k));
        scan.at(i, j, k) = static_cast<std::int16_t>(i < 3 ? -1000 : std::lround(50.0 + 350.0 * share));
    });
    const auto traced = core::traceVessels(scan);
    ASSERT_TRUE(traced) << traced.error().message;
    const auto passes = [&](const Eigen::Vector3d& place) {
        return std::ranges::any_of(traced.value().tree.branches, [&](const core::VesselBranch& branch) {
            return std::ranges::any_of(branch.pointsInPatient,
                                       [&](const Eigen::Vector3d& point) { return (point - place).norm() < 6.0; });
        });
    };
    EXPECT_TRUE(passes({-25, 0, 40}));
    EXPECT_TRUE(passes({45, 0, -20}));
    EXPECT_FALSE(passes({25, 0, 10}));
}

}   // namespace
