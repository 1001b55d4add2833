#include "core/imaging/image_filters.h"

#include <gtest/gtest.h>
#include <numeric>

using namespace angiopose;

namespace {

TEST(Blurred, IsTheSameForAnyNumberOfThreads)
{
    core::ImageF image(37, 29);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = static_cast<float>((i * 7919) % 251);
    }
    const core::ImageF alone = core::gaussianBlur(image, 1.7);
    for (const int threads : {2, 3, 40}) {
        EXPECT_EQ(core::gaussianBlur(image, 1.7, threads).pixels, alone.pixels) << threads;
    }
}

TEST(Blurred, KeepsTheSumAwayFromTheEdgeAndPlainImages)
{
    core::ImageF spot(41, 41);
    spot.at(20, 20) = 3.0F;
    const core::ImageF spread = core::gaussianBlur(spot, 2.0, 2);
    EXPECT_NEAR(std::accumulate(spread.pixels.begin(), spread.pixels.end(), 0.0), 3.0, 1e-4);
    EXPECT_LT(spread.at(20, 20), 0.2F);
    const core::ImageF plain(20, 10, 5.0F);
    for (const float value : core::gaussianBlur(plain, 3.0, 2).pixels) {
        EXPECT_NEAR(value, 5.0F, 1e-5F);
    }
}

TEST(ImageFilters, TheLargestAroundIsThatOfTheWindow)
{
    for (const auto& [width, height] : {std::pair(23, 17), std::pair(3, 9), std::pair(1, 1)}) {
        core::ImageF image(width, height);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            image.pixels[i] = static_cast<float>((i * 7919U) % 101U) - 50.0F;
        }
        for (const int radius : {0, 1, 3, 5, 12}) {
            const core::ImageF largest = core::maximumFilter(image, radius);
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    float expected = image.at(x, y);
                    for (int v = std::max(0, y - radius); v <= std::min(height - 1, y + radius); ++v) {
                        for (int u = std::max(0, x - radius); u <= std::min(width - 1, x + radius); ++u) {
                            expected = std::max(expected, image.at(u, v));
                        }
                    }
                    EXPECT_EQ(largest.at(x, y), expected) << radius << " at " << x << ", " << y;
                }
            }
        }
    }
}

}   // namespace
