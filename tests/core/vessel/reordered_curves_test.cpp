#include "core/vessel/reordered_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace angiopose::core {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// A winding vessel in whole pixels, as from a skeleton.
Points windingPixels()
{
    Points pixels;
    for (double u = 0.0; u < 200.0; u += 0.7) {
        const Eigen::Vector2d pixel(std::round(u), std::round(60.0 + 50.0 * std::sin(u / 25.0)));
        if (pixels.empty() || pixels.back() != pixel) {
            pixels.push_back(pixel);
        }
    }
    return pixels;
}

Centerline2d oneCurve(Points points)
{
    return {{{1, std::move(points), {}}}};
}

TEST(PutInOrder, LeavesCurvesAloneThatAreInOrder)
{
    EXPECT_FALSE(reorderCurves(oneCurve(windingPixels())));
    Centerline2d clicked = oneCurve({{0, 0}, {3, 0}, {40, 3}, {44, 5}, {90, 9}, {91, 12}, {92, 60}, {20, 90}, {0, 80}});
    EXPECT_FALSE(reorderCurves(clicked));
}

TEST(PutInOrder, ChainsPointsInAnyOrder)
{
    Points points = windingPixels();
    std::ranges::shuffle(points, std::mt19937(5));
    const auto found = reorderCurves(oneCurve(points));
    ASSERT_TRUE(found);
    EXPECT_EQ(points.size(), found->reorderedPoints);
    EXPECT_EQ(points.size(), found->curves.pointCount());
    for (const Curve2d& curve : found->curves.curves) {
        for (std::size_t i = 1; i < curve.pointsPx.size(); ++i) {
            EXPECT_LT((curve.pointsPx[i] - curve.pointsPx[i - 1]).norm(), 4.0);
        }
    }
}

TEST(PutInOrder, ChainsPixelsRowByRow)
{
    Points pixels = windingPixels();
    std::ranges::sort(pixels, {}, [](const Eigen::Vector2d& pixel) { return std::pair(pixel.y(), pixel.x()); });
    ASSERT_TRUE(reorderCurves(oneCurve(pixels)));
}

TEST(PutInOrder, ChainsPointsThatComeOneByOneAndKeepsCurves)
{
    Centerline2d given = oneCurve({{300, 300}, {303, 300}, {306, 301}, {309, 300}});
    for (const Eigen::Vector2d& point : windingPixels()) {
        given.curves.push_back({static_cast<int>(given.curves.size()) + 1, {point}, {}});
    }
    const auto found = reorderCurves(given);
    ASSERT_TRUE(found);
    EXPECT_EQ(given.curves.front().pointsPx, found->curves.curves.front().pointsPx);
    EXPECT_EQ(given.curves.size() - 1, found->reorderedPoints);
    EXPECT_LT(found->curves.curves.size(), 10U);
}

}   // namespace
}   // namespace angiopose::core
