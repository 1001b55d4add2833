#include "core/tracing/angiogram/curves/rasterize_vessels.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using core::Mask2d;

int pixelsAcross(const Mask2d& mask, int x)
{
    int count = 0;
    for (int y = 0; y < mask.height; ++y) {
        count += mask.at(x, y) != 0 ? 1 : 0;
    }
    return count;
}

TEST(PaintedVessels, AreAsWideAsTheirRadiiSay)
{
    const core::Curve2d curve{1, {{2.0, 20.0}, {42.0, 20.0}}, {2.0, 6.0}};
    const Mask2d mask = core::rasterizeVessels({{curve}}, 60, 40);
    EXPECT_EQ(pixelsAcross(mask, 2), 5);
    EXPECT_EQ(pixelsAcross(mask, 22), 9);
    EXPECT_EQ(pixelsAcross(mask, 41), 11);
    EXPECT_EQ(pixelsAcross(mask, 47), 7);   // rounded end
    EXPECT_EQ(pixelsAcross(mask, 49), 0);
}

TEST(PaintedVessels, AreCutByTheFrameAndNeedRadii)
{
    const Mask2d cut = core::rasterizeVessels({{{1, {{-5.0, -2.0}, {30.0, 11.0}}, {3.0, 3.0}}}}, 20, 10);
    EXPECT_NE(cut.at(19, 7), 0);
    const Mask2d none = core::rasterizeVessels({{{1, {{0.0, 5.0}, {19.0, 5.0}}, {}}}}, 20, 10);
    EXPECT_TRUE(std::ranges::all_of(none.pixels, [](std::uint8_t value) { return value == 0; }));
}

}   // namespace
