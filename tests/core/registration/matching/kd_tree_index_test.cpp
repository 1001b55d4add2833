#include "core/registration/matching/kd_tree_index.h"

#include "core/support/random.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

TEST(KdTreeIndex, AgreesWithExhaustiveSearchInsideAndFarOutside)
{
    CounterRandom random(41);
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 500; ++i) {
        points.emplace_back(random.uniform(0.0, 512.0), random.uniform(0.0, 512.0));
    }
    const auto index = makeKdTreeIndex(points);
    ASSERT_EQ(index->points(), points);
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Vector2d query(random.uniform(-2000.0, 3000.0), random.uniform(-2000.0, 3000.0));
        double smallest = (points.front() - query).norm();
        for (const Eigen::Vector2d& point : points) {
            smallest = std::min(smallest, (point - query).norm());
        }
        EXPECT_EQ((index->nearest(query) - query).norm(), smallest);
    }
}

TEST(KdTreeIndex, HoldsASinglePoint)
{
    const auto index = makeKdTreeIndex({{3.0, 4.0}});
    EXPECT_EQ(index->nearestIndex({100.0, -50.0}), 0u);
    EXPECT_EQ(index->nearest({0.0, 0.0}), Eigen::Vector2d(3.0, 4.0));
}

TEST(KdTreeIndex, CopesWithManyEqualPoints)
{
    const auto index = makeKdTreeIndex(std::vector<Eigen::Vector2d>(100, {7.0, 7.0}));
    EXPECT_EQ(index->nearest({0.0, 0.0}), Eigen::Vector2d(7.0, 7.0));
}

}   // namespace
