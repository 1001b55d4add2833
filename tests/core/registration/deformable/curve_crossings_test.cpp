#include "core/registration/deformable/curve_crossings.h"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr double quarter = 40.0 / 180.0 * std::numbers::pi;
const ProjectionCamera camera{1000.0, 1000.0, 256.0, 256.0, 512, 512};

TargetSamples sampled(const std::vector<std::vector<Eigen::Vector2d>>& curves)
{
    Centerline2d target;
    for (const auto& curve : curves) {
        target.curves.push_back({static_cast<int>(target.curves.size()), curve, {}});
    }
    return sampledTarget(target, {});
}

TEST(CurveCrossings, FindsCurvesOnBothSidesNearestFirst)
{
    const CurveCrossings curves(sampled({{{50, 100}, {400, 100}}, {{50, 130}, {400, 130}}, {{200, 20}, {200, 400}}}),
                                camera);
    std::vector<CurveCrossing> crossings;
    curves.find({{300, 110}, {0, 1}, 60.0}, quarter, 6, crossings);

    ASSERT_EQ(crossings.size(), 2u);
    EXPECT_NEAR(crossings[0].offsetPx, -10.0, 1e-9);
    EXPECT_NEAR(crossings[1].offsetPx, 20.0, 1e-9);
    EXPECT_EQ(crossings[1].curve, 1);
    curves.find({{300, 110}, {0, 1}, 60.0}, quarter, 1, crossings);
    EXPECT_EQ(crossings.size(), 1u);
    curves.find({{300, 110}, {0, 1}, 5.0}, quarter, 6, crossings);
    EXPECT_TRUE(crossings.empty());
}

TEST(CurveCrossings, LeavesOutCurvesOfAnotherDirection)
{
    const CurveCrossings curves(sampled({{{100, 100}, {200, 200}}}), camera);
    std::vector<CurveCrossing> crossings;
    curves.find({{140, 150}, {0, 1}, 60.0}, quarter, 6, crossings);   // the vessel runs along u, the curve at 45°
    EXPECT_TRUE(crossings.empty());
    curves.find({{140, 150}, {0, 1}, 60.0}, 1.0, 6, crossings);
    ASSERT_EQ(crossings.size(), 1u);
    EXPECT_NEAR(crossings[0].offsetPx, -10.0, 1e-9);
    EXPECT_NEAR(crossings[0].turn, std::numbers::pi / 4.0, 1e-9);
}

/// Whole pixels of a line that rises 1 in 7: within a fifth of a pixel of the line.
TEST(CurveCrossings, SmoothsTheStepsOfWholePixels)
{
    std::vector<Eigen::Vector2d> pixels;
    for (int u = 50; u < 400; ++u) {
        pixels.push_back({u, std::round(100.0 + u / 7.0)});
    }
    const CurveCrossings curves(sampled({pixels}), camera);
    std::vector<CurveCrossing> crossings;
    for (double u = 80.0; u < 350.0; u += 3.3) {
        curves.find({{u, 100.0 + u / 7.0}, {0, 1}, 10.0}, quarter, 6, crossings);
        ASSERT_EQ(crossings.size(), 1u);
        EXPECT_LT(std::abs(crossings[0].offsetPx), 0.45);
    }
}

TEST(CurveCrossings, SinglePointsAreNoCurves)
{
    EXPECT_FALSE(CurveCrossings(sampled({{{5, 5}}, {{8, 8}}}), camera).hasCurves());
}

}   // namespace
}   // namespace angiopose::core
