#include "core/registration/deformable/curve_crossings.h"

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

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
    return sampleTarget(target, {});
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

/// A line rasterized to whole pixels that rises 1 in 7 is found within a fifth of a pixel of the true line.
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

/// For straight curves and queries in all directions, the cells yield the same crossings as testing every curve.
TEST(CurveCrossings, AreAllFoundAlongLinesOfAnySlope)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(60.0, 450.0), heading(0.0, 2.0 * std::numbers::pi);
    const auto unit = [&] {
        const double angle = heading(random);
        return Eigen::Vector2d(std::cos(angle), std::sin(angle));
    };
    std::vector<std::vector<Eigen::Vector2d>> lines;
    for (int k = 0; k < 60; ++k) {
        const Eigen::Vector2d from(place(random), place(random));
        lines.push_back({from, from + 50.0 * unit()});
    }
    const CurveCrossings curves(sampled(lines), camera);
    std::vector<CurveCrossing> found;
    std::size_t count = 0;
    for (int k = 0; k < 500; ++k) {
        const CrossingQuery query{{place(random), place(random)}, unit(), 60.0};
        curves.find(query, 0.5 * std::numbers::pi, 1000, found);
        std::vector<double> wanted;
        for (const auto& line : lines) {
            Eigen::Matrix2d system;
            system << query.normal, line[0] - line[1];
            const Eigen::Vector2d at =
                system.inverse() * (line[0] - query.positionPx);   // parameters along the query and along the line
            if (std::abs(at[0]) < query.reachPx && at[1] > 0.0 && at[1] < 1.0) {
                wanted.push_back(at[0]);
            }
        }
        std::ranges::sort(wanted, {}, [](double offset) { return std::abs(offset); });
        ASSERT_EQ(found.size(), wanted.size()) << k;
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            EXPECT_NEAR(found[i].offsetPx, wanted[i], 1e-6);
        }
        count += wanted.size();
    }
    EXPECT_GT(count, 500u);
}

TEST(CurveCrossings, SinglePointsAreNoCurves)
{
    EXPECT_FALSE(CurveCrossings(sampled({{{5, 5}}, {{8, 8}}}), camera).hasCurves());
}

}   // namespace
}   // namespace angiopose::core
