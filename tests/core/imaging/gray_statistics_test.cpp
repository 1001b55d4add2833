#include "core/imaging/gray_statistics.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <random>

using namespace angiopose;

namespace {

TEST(GrayStatistics, RankedValuesAreThoseOfTheSortedOnes)
{
    std::mt19937 random(7);
    std::vector<float> values(1001);
    for (float& value : values) {
        value = static_cast<float>(random() % 300);
    }
    std::vector<float> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const std::vector<float> found = core::grayQuantiles(values, {0.0, 0.002, 0.5, 0.5, 0.99, 1.0});
    EXPECT_EQ(found, (std::vector<float>{sorted[0], sorted[2], sorted[500], sorted[500], sorted[990], sorted[1000]}));
    EXPECT_EQ(core::grayQuantile(values, 0.25), sorted[250]);
}

TEST(GrayStatistics, SoAreThoseOfManyValuesOfEitherSignAndEveryOrderOfMagnitude)
{
    std::mt19937 random(11);
    std::vector<float> values(30001);
    for (float& value : values) {
        const auto magnitude = static_cast<float>(
            std::ldexp(1.0 + static_cast<double>(random() % 1000) * 1e-3, static_cast<int>(random() % 40) - 20));
        value = random() % 3 == 0 ? 0.0F : random() % 2 == 0 ? magnitude : -magnitude;
    }
    std::vector<float> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(core::grayQuantiles(values, {0.0, 0.1, 0.5, 0.9, 1.0}),
              (std::vector<float>{sorted[0], sorted[3000], sorted[15000], sorted[27000], sorted[30000]}));
    EXPECT_EQ(core::grayQuantile(std::vector<float>(5000, 7.0F), 0.3), 7.0F);
}

}   // namespace
