#include "core/tracing/angiogram/curves/thin_mask.h"

#include "core/imaging/image_filters.h"
#include "core/imaging/mask_morphology.h"
#include "core/support/random.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using core::Mask2d;

/// Euler number of an 8-connected mask, components minus holes, from its 2×2 windows (Gray 1971).
int eulerNumber(const Mask2d& mask)
{
    int sum = 0;
    for (int y = -1; y < mask.height; ++y) {
        for (int x = -1; x < mask.width; ++x) {
            const auto set = [&](int dx, int dy) {
                return mask.contains(x + dx, y + dy) && mask.at(x + dx, y + dy) != 0 ? 1 : 0;
            };
            const int count = set(0, 0) + set(1, 0) + set(0, 1) + set(1, 1);
            const bool diagonal = count == 2 && set(0, 0) == set(1, 1);
            sum += count == 1 ? 1 : count == 3 ? -1 : diagonal ? -2 : 0;
        }
    }
    return sum / 4;
}

Mask2d blobs(std::uint64_t seed)
{
    core::CounterRandom random(seed);
    core::ImageF noise(48, 40);
    for (float& value : noise.pixels) {
        value = static_cast<float>(random.normal());
    }
    const core::ImageF smooth = core::gaussianBlur(noise, random.uniform(0.3, 2.0));
    Mask2d mask(noise.width, noise.height);
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
        mask.pixels[i] = smooth.pixels[i] > 0.0F ? 255 : 0;
    }
    return mask;
}

TEST(ThinMask, KeepsComponentsAndHolesOfRandomMasks)
{
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Mask2d mask = blobs(seed);
        const Mask2d skeleton = core::skeletonize(mask);
        EXPECT_EQ(core::componentsOf(skeleton).size(), core::componentsOf(mask).size()) << seed;
        EXPECT_EQ(eulerNumber(skeleton), eulerNumber(mask)) << seed;
        for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
            EXPECT_TRUE(skeleton.pixels[i] == 0 || mask.pixels[i] != 0);
        }
    }
}

TEST(ThinMask, LeavesNoPixelThatCouldStillGo)
{
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Mask2d skeleton = core::skeletonize(blobs(seed));
        EXPECT_EQ(core::skeletonize(skeleton).pixels, skeleton.pixels) << seed;
    }
}

TEST(ThinMask, ABarBecomesItsMiddleLine)
{
    Mask2d bar(60, 21);
    test::forEachPixel({5, 6}, {55, 15}, [&](int x, int y) { bar.at(x, y) = 255; });
    const Mask2d skeleton = core::skeletonize(bar);
    for (int x = 12; x < 48; ++x) {
        int set = 0;
        for (int y = 0; y < skeleton.height; ++y) {
            set += skeleton.at(x, y) != 0 ? 1 : 0;
        }
        EXPECT_EQ(set, 1) << x;
        EXPECT_NE(skeleton.at(x, 10), 0) << x;
    }
}

TEST(ThinMask, EdgesOfTheImageAreNoDanger)
{
    EXPECT_TRUE(core::skeletonize(Mask2d()).isEmpty());
    EXPECT_EQ(core::componentsOf(core::skeletonize(Mask2d(1, 1, 255))).size(), 1U);
    EXPECT_EQ(core::componentsOf(core::skeletonize(Mask2d(7, 30, 255))).size(), 1U);
}

}   // namespace
