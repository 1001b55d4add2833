#include "core/support/quantile.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

using namespace angiopose;

namespace {

using namespace core;

TEST(Quantile, InterpolatesBetweenNeighbors)
{
    EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.75), 3.25);
    EXPECT_DOUBLE_EQ(quantile({5.0, 1.0, 3.0}, 0.5), 3.0);
}

TEST(Quantile, EndsAreTheExtremes)
{
    const std::vector<double> ends = quantiles({7.0, -2.0, 3.0}, {0.0, 1.0});
    EXPECT_EQ(ends[0], -2.0);
    EXPECT_EQ(ends[1], 7.0);
}

TEST(Quantile, FractionsComeInAnyOrder)
{
    std::vector<double> values;
    for (int k = 0; k <= 100; ++k) {
        values.push_back((37 * k) % 101);
    }
    const std::vector<double> expected{20.0, 75.0, 95.0, 50.0, 95.0};
    EXPECT_EQ(quantiles(values, {0.2, 0.75, 0.95, 0.5, 0.95}), expected);
}

TEST(Quantile, OfNothingIsNotANumber)
{
    EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(Quantile, InfiniteTailLeavesTheMedianAlone)
{
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(quantile({1.0, 2.0, infinity}, 0.5), 2.0);
    EXPECT_EQ(quantile({1.0, infinity, infinity}, 0.5), infinity);
}

}   // namespace
