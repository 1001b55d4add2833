#include "core/registration/deformable/tree_matching.h"

#include "core/support/random.h"

#include <gtest/gtest.h>
#include <cmath>

namespace angiopose::core {
namespace {

/// A trunk of three knots with two branches of two knots at its end.
VesselTree treeWithAFork()
{
    VesselTree tree;
    tree.branches.push_back({1, "", {{0, 0, 0}, {0, 0, 10}}, {}, -1});
    tree.branches.push_back({2, "", {{0, 0, 10}, {5, 0, 15}}, {}, -1});
    tree.branches.push_back({3, "", {{0, 0, 10}, {-5, 0, 15}}, {}, -1});
    return tree;
}

TEST(TreeKnots, BranchesThatMeetAreLinkedToOneForest)
{
    const TreeKnots knots = treeKnots(treeWithAFork(), {3}, 5.0);

    ASSERT_EQ(knots.size(), 7u);
    EXPECT_EQ(knots.links.size(), 6u);   // all links form one connected piece
    EXPECT_EQ(knots.isUsed[6], 0);
    EXPECT_EQ(knots.isUsed[4], 1);
    EXPECT_EQ(knots.branchOf(4), 1u);
    EXPECT_DOUBLE_EQ(knots.lengthMm[0] + knots.lengthMm[1] + knots.lengthMm[2], 10.0);
    const Eigen::MatrixXd distances = knots.distancesAlongTree();
    EXPECT_DOUBLE_EQ(distances(0, 2), 10.0);
    EXPECT_NEAR(distances(4, 6), 2.0 * std::sqrt(50.0), 1.1);   // up one branch, down the other
    EXPECT_TRUE(distances.isApprox(distances.transpose()));
}

TEST(TreeKnots, LoopsAreCutAndPiecesStayApart)
{
    VesselTree tree = treeWithAFork();
    tree.branches.push_back({4, "", {{5, 0, 15}, {-5, 0, 15}}, {}, -1});
    tree.branches.push_back({5, "", {{100, 0, 0}, {110, 0, 0}}, {}, -1});
    const TreeKnots knots = treeKnots(tree, {}, 5.0);

    EXPECT_EQ(knots.links.size(), knots.size() - 2);
    EXPECT_TRUE(std::isinf(knots.distancesAlongTree()(0, static_cast<Eigen::Index>(knots.size()) - 1)));
}

/// A wrong candidate loses if its neighbors agree on another one, although it would win on its own.
TEST(MatchAlongTree, NeighborsOutvoteTheNearerCurve)
{
    const TreeKnots knots = treeKnots(treeWithAFork(), {}, 5.0);
    std::vector<KnotChoice> choices(knots.size());
    for (std::size_t k = 0; k < choices.size(); ++k) {
        choices[k].normal = Eigen::Vector2d::UnitX();
        choices[k].candidates = {{4.0, 0.5, 1, 0.0}};
    }
    choices[1].candidates = {{0.1, 0.1, 2, 0.0}, {4.0, 0.5, 1, 0.0}};
    matchAlongTree(knots, {0.1, 0.1}, choices);

    EXPECT_GT(choices[1].candidates[1].probability, 0.9);
    EXPECT_LT(choices[1].candidates[0].probability, 0.1);
    EXPECT_GT(choices[5].candidates[0].probability, 0.9);
}

/// Compares with the sum over all joint states of five knots: normalized marginals do not depend on the order of the
/// knots.
TEST(MatchAlongTree, ProbabilitiesAreOfOneJointDistribution)
{
    VesselTree line;
    line.branches.push_back({1, "", {{0, 0, 0}, {0, 0, 20}}, {}, -1});
    VesselTree back = line;
    std::swap(back.branches[0].pointsInPatient[0], back.branches[0].pointsInPatient[1]);
    CounterRandom random(4);
    std::vector<KnotChoice> forward(5);
    for (KnotChoice& choice : forward) {
        choice.normal = Eigen::Vector2d(1.0, 0.3 * random.normal()).normalized();
        for (int c = 0; c < 3; ++c) {
            choice.candidates.push_back({2.0 * random.normal(), random.uniform(), random.index(2), 0.0});
        }
    }
    std::vector<KnotChoice> backward(forward.rbegin(), forward.rend());
    matchAlongTree(treeKnots(line, {}, 5.0), {0.3, 0.2}, forward);
    matchAlongTree(treeKnots(back, {}, 5.0), {0.3, 0.2}, backward);
    for (std::size_t k = 0; k < 5; ++k) {
        double sum = 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(forward[k].candidates[c].probability, backward[4 - k].candidates[c].probability, 1e-12);
            sum += forward[k].candidates[c].probability;
        }
        EXPECT_GT(sum, 0.0);
        EXPECT_LT(sum, 1.0);
    }
}

}   // namespace
}   // namespace angiopose::core
