#include "core/registration/pnp/branch_graph.h"
#include "core/registration/pnp/traced_path.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using namespace core;

/// Points 1 apart from one position toward another.
template <class Point>
std::vector<Point> pointsFromTo(const Point& from, const Point& to)
{
    const auto steps = static_cast<int>((to - from).norm());
    std::vector<Point> points;
    for (int k = 0; k <= steps; ++k) {
        points.push_back(from + static_cast<double>(k) / steps * (to - from));
    }
    return points;
}

TreeSamples treeOf(const std::vector<std::vector<Eigen::Vector3d>>& branches)
{
    TreeSamples tree;
    for (std::size_t b = 0; b < branches.size(); ++b) {
        tree.points.insert(tree.points.end(), branches[b].begin(), branches[b].end());
        tree.branchIndex.insert(tree.branchIndex.end(), branches[b].size(), static_cast<int>(b));
    }
    return tree;
}

TargetSamples targetOf(const std::vector<std::vector<Eigen::Vector2d>>& curves)
{
    TargetSamples target;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        target.points.insert(target.points.end(), curves[c].begin(), curves[c].end());
        target.curveIndex.insert(target.curveIndex.end(), curves[c].size(), static_cast<int>(c));
    }
    return target;
}

std::vector<std::size_t> meetingCounts(const BranchGraph& graph)
{
    std::vector<std::size_t> counts;
    for (const std::vector<EdgeEnd>& node : graph.nodes) {
        counts.push_back(node.size());
    }
    std::ranges::sort(counts);
    return counts;
}

const std::vector<Eigen::Vector2d> trunk = pointsFromTo<Eigen::Vector2d>({0.0, 50.0}, {100.0, 50.0});
const std::vector<Eigen::Vector2d> side = pointsFromTo<Eigen::Vector2d>({60.0, 52.0}, {60.0, 100.0});

EdgeEnd outOf(const BranchGraph& graph, const TargetSamples& target, const Eigen::Vector2d& place)
{
    for (const std::vector<EdgeEnd>& node : graph.nodes) {
        const BranchEdge& edge = graph.edges[static_cast<std::size_t>(node.front().edge)];
        const std::size_t point = node.front().isReversed ? edge.to - 1 : edge.from;
        if (node.size() == 1 && (target.points[point] - place).norm() < 1.0) {
            return node.front();
        }
    }
    ADD_FAILURE() << "no end at " << place.transpose();
    return {};
}

TEST(BranchGraph, CutsABranchWhereAnotherLeavesIt)
{
    const BranchGraph graph = graphOf(treeOf({pointsFromTo<Eigen::Vector3d>({0, 0, 0}, {40, 0, 0}),
                                              pointsFromTo<Eigen::Vector3d>({20, 1, 0}, {20, 30, 0})}));
    ASSERT_EQ(graph.edges.size(), 3U);
    EXPECT_EQ(meetingCounts(graph), (std::vector<std::size_t>{1, 1, 1, 3}));
    EXPECT_EQ(graph.edges[0].curve, 0);
    EXPECT_EQ(graph.edges[1].curve, 0);
    EXPECT_EQ(graph.edges[2].curve, 1);
    EXPECT_EQ(graph.edges[0].to, graph.edges[1].from);
    EXPECT_EQ(graph.targetNode({0, false}), graph.targetNode({1, true}));   // both walks end at the bifurcation
    EXPECT_EQ(graph.targetNode({0, false}), graph.targetNode({2, true}));
}

TEST(BranchGraph, CurvesThatOnlyCrossDoNotMeet)
{
    const BranchGraph graph = graphOf(targetOf({trunk, pointsFromTo<Eigen::Vector2d>({50, 0}, {50, 100})}));
    EXPECT_EQ(graph.edges.size(), 2U);
    EXPECT_EQ(meetingCounts(graph), (std::vector<std::size_t>{1, 1, 1, 1}));
}

TEST(BranchGraph, ARingStaysARing)
{
    const BranchGraph graph = graphOf(treeOf({pointsFromTo<Eigen::Vector3d>({0, 0, 0}, {40, 0, 0}),
                                              pointsFromTo<Eigen::Vector3d>({0, 1, 0}, {20, 30, 0}),
                                              pointsFromTo<Eigen::Vector3d>({20, 30, 0}, {40, 1, 0})}));
    EXPECT_EQ(graph.edges.size(), 3U);
    EXPECT_EQ(meetingCounts(graph), (std::vector<std::size_t>{2, 2, 2}));
}

TEST(BranchGraph, OfNothingIsEmpty)
{
    EXPECT_TRUE(graphOf(TreeSamples{}).nodes.empty());
}

TEST(TracedPath, GoesStraightOnThroughANode)
{
    const TargetSamples target = targetOf({trunk, side});
    const BranchGraph graph = graphOf(target);
    ASSERT_EQ(graph.edges.size(), 3U);
    const TracedPath path = followPath(graph, target, outOf(graph, target, {0.0, 50.0}), 95.0);
    EXPECT_EQ(path.edges.size(), 2U);
    EXPECT_NEAR(path.lengthPx, 100.0, 1.0);
    EXPECT_LT((path.points.back() - Eigen::Vector2d(100.0, 50.0)).norm(), 1e-9);
    ASSERT_NE(path.endNode, TracedPath::noNode);
    EXPECT_EQ(graph.nodes[static_cast<std::size_t>(path.endNode)].size(), 1U);
}

TEST(TracedPath, EndsAtTheNodeWhereItIsLongEnoughAndInBetweenWhereTooLong)
{
    const TargetSamples target = targetOf({trunk, side});
    const BranchGraph graph = graphOf(target);
    const EdgeEnd start = outOf(graph, target, {0.0, 50.0});
    const TracedPath asLong = followPath(graph, target, start, 60.0);
    EXPECT_EQ(asLong.edges.size(), 1U);
    ASSERT_NE(asLong.endNode, TracedPath::noNode);
    EXPECT_EQ(graph.nodes[static_cast<std::size_t>(asLong.endNode)].size(), 3U);
    const TracedPath cut = followPath(graph, target, start, 30.0);
    EXPECT_EQ(cut.endNode, TracedPath::noNode);
    EXPECT_DOUBLE_EQ(cut.lengthPx, 30.0);
}

TEST(TracedPath, TurnsIntoNoOtherVessel)
{
    const TargetSamples target = targetOf({trunk, side});
    const BranchGraph graph = graphOf(target);
    const TracedPath path = followPath(graph, target, outOf(graph, target, {60.0, 100.0}), 200.0);
    EXPECT_EQ(path.edges.size(), 1U);   // both continuations turn by 90°
    EXPECT_NE(path.endNode, TracedPath::noNode);
}

TEST(TracedPath, PlacesLieAlongThePolyline)
{
    EXPECT_LT((pointAtLength(side, 10.5) - Eigen::Vector2d(60.0, 62.5)).norm(), 1e-12);
    EXPECT_EQ(pointAtLength(side, -3.0), side.front());
    EXPECT_EQ(pointAtLength(side, 1e6), side.back());
    EXPECT_DOUBLE_EQ(lengthOf(side), 48.0);
}

}   // namespace
