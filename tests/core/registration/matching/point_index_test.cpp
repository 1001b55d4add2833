#include "core/registration/matching/feature_map.h"
#include "core/registration/matching/grid_index.h"

#include "core/support/random.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

std::vector<Eigen::Vector2d> randomPoints(int count, double low, double high, std::uint64_t seed)
{
    CounterRandom random(seed);
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < count; ++i) {
        const double x = random.uniform(low, high);
        points.emplace_back(x, random.uniform(low, high));
    }
    return points;
}

double nearestDistance(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& query)
{
    double best = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& point : points) {
        best = std::min(best, (point - query).norm());
    }
    return best;
}

TEST(GridIndex, FindsTheNearestPointAnywhere)
{
    const auto points = randomPoints(400, 100.0, 300.0, 1);
    const GridIndex index(points);
    for (const Eigen::Vector2d& query : randomPoints(2000, -500.0, 900.0, 2)) {
        EXPECT_DOUBLE_EQ((index.nearest(query) - query).norm(), nearestDistance(points, query));
    }
}

TEST(GridIndex, FindsTheNearestPointWhateverTheGuess)
{
    const auto points = randomPoints(400, 100.0, 300.0, 1);
    const GridIndex index(points);
    std::size_t guess = 0;
    for (const Eigen::Vector2d& query : randomPoints(2000, -500.0, 900.0, 2)) {
        EXPECT_EQ(index.nearestIndex(query, guess), index.nearestIndex(query));
        guess = (guess + 37) % points.size();
    }
}

TEST(GridIndex, TakesASinglePointAndFarOutliers)
{
    EXPECT_EQ(GridIndex({{3.0, 4.0}}).nearestIndex({-1e5, 7.0}), 0u);
    const GridIndex index({{0.0, 0.0}, {1e6, 1e6}, {1.0, 0.0}});
    EXPECT_EQ(index.nearestIndex({0.9, 0.1}), 2u);
    EXPECT_EQ(index.nearestIndex({9e5, 9e5}), 1u);
}

TEST(FeatureMap, FindsAPointWithinACellsDiagonalOfTheNearest)
{
    const auto points = randomPoints(300, 0.0, 255.0, 3);
    const FeatureMap map(points, 256, 256);
    // The query and the point may each be half a diagonal away from the centers of their cells.
    const double tolerance = 2.0 * FeatureMap::cellPx * std::sqrt(2.0);
    for (const Eigen::Vector2d& query : randomPoints(2000, -40.0, 300.0, 4)) {
        EXPECT_LE((map.nearest(query) - query).norm(), nearestDistance(points, query) + tolerance);
    }
}

TEST(FeatureMap, AnswersFarOutsideTheImage)
{
    const FeatureMap map({{10.0, 10.0}, {200.0, 200.0}}, 256, 256);
    EXPECT_EQ(map.nearestIndex({-5000.0, -5000.0}), 0u);
    EXPECT_EQ(map.nearestIndex({5000.0, 5000.0}), 1u);
}

}   // namespace
}   // namespace angiopose::core
