#include "core/tracing/tree/branch_paths.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using Point = Eigen::Vector3d;

/// Vessels that run straight from node to node with linearly changing radii.
class Vessels {
public:
    int addNode(const Point& placeMm, double radiusMm)
    {
        graph.nodesMm.push_back(placeMm);
        graph.nodeRadiusMm.push_back(radiusMm);
        return static_cast<int>(graph.nodesMm.size()) - 1;
    }

    void add(int from, int to, double radiusMm, double endRadiusMm)
    {
        const Point& start = graph.nodesMm[static_cast<std::size_t>(from)];
        const Point way = graph.nodesMm[static_cast<std::size_t>(to)] - start;
        core::VesselEdge edge{from, to, {}, {}};
        const int steps = static_cast<int>(way.norm());
        for (int n = 0; n <= steps; ++n) {
            const double share = static_cast<double>(n) / steps;
            edge.pointsMm.emplace_back(start + share * way);
            edge.radiusMm.push_back(radiusMm + share * (endRadiusMm - radiusMm));
        }
        graph.edges.push_back(std::move(edge));
    }

    core::VesselGraph graph;
};

TEST(BranchPaths, BeginAtTheThickestEnd)
{
    Vessels tree;
    const int top = tree.addNode({0, 0, 100}, 8);
    const int fork = tree.addNode({0, 0, 0}, 7);
    tree.add(top, fork, 8, 7);
    tree.add(fork, tree.addNode({40, 0, -60}, 4), 5, 4);
    tree.add(fork, tree.addNode({-40, 0, -60}, 4), 5, 4);
    const auto paths = core::splitIntoPaths(tree.graph, std::nullopt, {});
    ASSERT_EQ(paths.size(), 2U);
    EXPECT_EQ(paths.front().pointsMm.front(), Point(0, 0, 100));
    const auto asked = core::splitIntoPaths(tree.graph, Point(40, 0, -60), {});
    EXPECT_EQ(asked.front().pointsMm.front(), Point(40, 0, -60));
}

TEST(BranchPaths, BeginWhereTheAortaDoesWithCoronaryArteriesAtItsEnd)
{
    Vessels tree;
    const int root = tree.addNode({0, 0, 0}, 13);
    const int arch = tree.addNode({0, 0, 70}, 8);
    tree.add(root, tree.addNode({30, 0, 0}, 1), 2, 1);
    tree.add(root, tree.addNode({-35, 0, 0}, 1), 1.5, 1);
    tree.add(root, arch, 13, 12);
    tree.add(arch, tree.addNode({0, 60, -80}, 7), 8, 7);
    tree.add(arch, tree.addNode({0, 0, 120}, 4), 5, 4);
    const auto paths = core::splitIntoPaths(tree.graph, std::nullopt, {});
    ASSERT_FALSE(paths.empty());
    EXPECT_EQ(paths.front().pointsMm.front().z(), 0.0);
}

TEST(BranchPaths, DoNotBeginAtStumpsOnWideVessels)
{
    Vessels tree;
    const int top = tree.addNode({0, 0, 80}, 8);
    const int bulge = tree.addNode({0, 0, 0}, 12);
    tree.add(top, bulge, 8, 8);
    tree.add(bulge, tree.addNode({0, 0, -80}, 6), 7, 6);
    tree.add(bulge, tree.addNode({15, 0, 0}, 2), 12, 2);
    const auto paths = core::splitIntoPaths(tree.graph, std::nullopt, {});
    ASSERT_EQ(paths.size(), 2U);
    EXPECT_EQ(paths.front().pointsMm.front(), Point(0, 0, 80));
    EXPECT_EQ(paths.front().pointsMm.back(), Point(0, 0, -80));
}

}   // namespace
