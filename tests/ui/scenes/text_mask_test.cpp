#include "ui/scenes/text_mask.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace angiopose;

namespace {

core::Mask2d maskOf(const char* text)
{
    return ui::textMask({text}, 20, ui::TextAlign::Left);
}

long coverageOf(const core::Mask2d& mask)
{
    return std::accumulate(mask.pixels.begin(), mask.pixels.end(), 0L);
}

TEST(TextMask, DrawsLatinTextInTheInterfaceFont)
{
    EXPECT_GT(coverageOf(maskOf("frame 4 of 10")), 0L);
    EXPECT_GT(maskOf("wider text").width, maskOf("text").width);
}

TEST(TextMask, DrawsSignsThatTheInterfaceFontLacks)
{
    const core::Mask2d blood = maskOf("血");
    const core::Mask2d pipe = maskOf("管");
    EXPECT_GT(coverageOf(blood), 0L);
    EXPECT_NE(blood.pixels, pipe.pixels);   // not the same placeholder box for both
}

TEST(TextMask, EndsAtABrokenSequence)
{
    EXPECT_EQ(maskOf("ab\xe8\xa1").pixels, maskOf("ab").pixels);
}

}   // namespace
