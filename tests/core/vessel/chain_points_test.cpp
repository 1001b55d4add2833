#include "core/vessel/chain_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace angiopose::core {
namespace {

using Points = std::vector<Eigen::Vector2d>;

Points shuffled(Points points)
{
    std::ranges::shuffle(points, std::mt19937(3));
    return points;
}

double longestStep(const Centerline2d& centerline)
{
    double longest = 0.0;
    for (const Curve2d& curve : centerline.curves) {
        for (std::size_t i = 1; i < curve.pointsPx.size(); ++i) {
            longest = std::max(longest, (curve.pointsPx[i] - curve.pointsPx[i - 1]).norm());
        }
    }
    return longest;
}

TEST(ChainPoints, PutsALineInOrder)
{
    Points line;
    for (int i = 0; i < 50; ++i) {
        line.emplace_back(3.0 * i, 40.0 - i);
    }
    const Centerline2d chained = chainPoints(shuffled(line));
    ASSERT_EQ(1U, chained.curves.size());
    Points found = chained.curves.front().pointsPx;
    if (found.front().x() > found.back().x()) {
        std::ranges::reverse(found);
    }
    EXPECT_EQ(line, found);
}

TEST(ChainPoints, CutsAtForksAndBetweenPieces)
{
    Points points;
    for (int i = 0; i < 30; ++i) {
        points.emplace_back(i, 0.0);
        points.emplace_back(100.0 + i, 0.0);
        if (i > 0) {
            points.emplace_back(15.0, i);
        }
    }
    const Centerline2d chained = chainPoints(shuffled(points));
    EXPECT_EQ(points.size(), chained.pointCount());
    EXPECT_EQ(4U, chained.curves.size());   // three arms, one including the bifurcation, plus the separate piece
    EXPECT_LE(longestStep(chained), 1.5);
}

TEST(ChainPoints, KeepsLonePointsAndRepeatedOnes)
{
    EXPECT_TRUE(chainPoints({}).curves.empty());
    EXPECT_EQ(1U, chainPoints({{5, 5}}).curves.size());
    EXPECT_EQ(3U, chainPoints({{5, 5}, {5, 5}, {5, 5}}).pointCount());
    EXPECT_EQ(2U, chainPoints({{5, 5}, {6, 5}, {7, 5}, {300, 5}}).curves.size());
}

}   // namespace
}   // namespace angiopose::core
