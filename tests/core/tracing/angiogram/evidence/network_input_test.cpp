#include "core/tracing/angiogram/evidence/network_input.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using core::ImageF;
using core::NetworkInput;

TEST(Resampled, KeepsMeansWhenSmallerAndSlopesWhenLarger)
{
    ImageF slope(12, 9);
    for (int y = 0; y < slope.height; ++y) {
        for (int x = 0; x < slope.width; ++x) {
            slope.at(x, y) = static_cast<float>(x);
        }
    }
    const ImageF small = core::resampled(slope, 5, 4);
    ASSERT_EQ(small.width, 5);
    ASSERT_EQ(small.height, 4);
    EXPECT_NEAR(small.at(0, 0), 0.75, 1e-5);   // mean of pixels 0, 1 and 0.4 of pixel 2
    EXPECT_NEAR(small.at(2, 2), 5.5, 1e-5);
    const ImageF large = core::resampled(slope, 24, 9);
    EXPECT_NEAR(large.at(11, 3), 5.25, 1e-5);
    EXPECT_NEAR(large.at(0, 3), 0.0, 1e-5);
}

TEST(NetworkInput, IsPaddedToWholeCellsAndBounded)
{
    const NetworkInput input = core::networkInput(ImageF(1000, 500, 3.0F));
    EXPECT_LE(input.width * input.height, 390 * 390);
    EXPECT_NEAR(input.width, 2 * input.height, 2);
    EXPECT_EQ(input.paddedWidth % 16, 0);
    EXPECT_EQ(input.paddedHeight % 16, 0);
    EXPECT_EQ(input.values.size(), 2U * static_cast<std::size_t>(input.paddedWidth * input.paddedHeight));
    EXPECT_TRUE(std::ranges::all_of(input.values, [](float value) { return value >= -4.0F && value <= 4.0F; }));
}

}   // namespace
