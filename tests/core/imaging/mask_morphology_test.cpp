#include "core/imaging/mask_morphology.h"

#include "core/support/random.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using core::Mask2d;

Mask2d sparse(int width, int height, double share)
{
    Mask2d mask(width, height);
    core::CounterRandom random(9);
    for (std::uint8_t& pixel : mask.pixels) {
        pixel = random.uniform() < share ? 1 : 0;
    }
    return mask;
}

bool anyAround(const Mask2d& mask, int x, int y, int radius)
{
    for (int near = y - radius; near <= y + radius; ++near) {
        for (int beside = x - radius; beside <= x + radius; ++beside) {
            if (mask.contains(beside, near) && mask.at(beside, near) != 0) {
                return true;
            }
        }
    }
    return false;
}

TEST(MaskMorphology, DilationReachesAsFarAsItsRadius)
{
    for (const auto& [width, height] : {std::pair{40, 23}, {5, 60}, {1, 9}, {12, 1}}) {
        const Mask2d mask = sparse(width, height, 0.01);
        for (const int radius : {0, 1, 2, 3, 5, 6, 10, 17}) {
            const Mask2d grown = core::dilate(mask, radius);
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    ASSERT_EQ(grown.at(x, y), anyAround(mask, x, y, radius) ? 255 : 0)
                        << x << ' ' << y << ' ' << radius;
                }
            }
        }
    }
}

TEST(MaskMorphology, ErosionIsDilationOfTheRestAndIgnoresTheImageEdge)
{
    Mask2d mask(30, 20, 1);
    mask.at(10, 10) = 0;
    const Mask2d shrunk = core::erode(mask, 3);
    EXPECT_EQ(shrunk.at(0, 0), 255);
    EXPECT_EQ(shrunk.at(7, 7), 0);
    EXPECT_EQ(shrunk.at(6, 10), 255);
    EXPECT_EQ(std::count(shrunk.pixels.begin(), shrunk.pixels.end(), 0), 49);
}

TEST(MaskMorphology, EmptyMasksStayEmpty)
{
    EXPECT_TRUE(core::dilate({}, 3).isEmpty());
    EXPECT_TRUE(core::erode({}, 3).isEmpty());
}

}   // namespace
