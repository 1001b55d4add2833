#include "core/imaging/grey_statistics.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <random>

using namespace angiopose;

namespace {

TEST(GreyStatistics, RankedValuesAreThoseOfTheSortedOnes)
{
    std::mt19937 random(7);
    std::vector<float> values(1001);
    for (float& value : values) {
        value = static_cast<float>(random() % 300);
    }
    std::vector<float> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const std::vector<float> found = core::rankedAt(values, {0.0, 0.002, 0.5, 0.5, 0.99, 1.0});
    EXPECT_EQ(found, (std::vector<float>{sorted[0], sorted[2], sorted[500], sorted[500], sorted[990], sorted[1000]}));
    EXPECT_EQ(core::ranked(values, 0.25), sorted[250]);
}

}   // namespace
