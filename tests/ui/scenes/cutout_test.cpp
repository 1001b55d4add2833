#include "ui/scenes/cutout.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

constexpr std::uint32_t bare = 0xFF101010U;
constexpr std::uint32_t covered = 0xFFFFFFFFU;

std::vector<std::uint32_t> cut(const ui::Cutout& cutout)
{
    std::vector<std::uint32_t> pixels(100 * 50, covered);
    // 2 device px per image px; the canvas starts at image (10, 20).
    ui::applyCutout(cutout, {9.5, 59.5, 19.5, 44.5}, std::vector<std::uint32_t>(100 * 50, bare),
                    {pixels.data(), 100, 50}, {0, 50});
    return pixels;
}

TEST(Cutout, LeavesThePictureAloneWhenOff)
{
    EXPECT_EQ(cut({}), std::vector<std::uint32_t>(100 * 50, covered));
}

TEST(Cutout, SwipeBaresEverythingToTheRight)
{
    const auto pixels = cut({ui::Cutout::Shape::RightOf, {29.5, 0.0}, 0.0});   // device column 40
    for (std::size_t y = 0; y < 50; ++y) {
        EXPECT_EQ(pixels[100 * y + 39], covered);
        EXPECT_NE(pixels[100 * y + 40], covered);   // the edge
        EXPECT_EQ(pixels[100 * y + 41], bare);
        EXPECT_EQ(pixels[100 * y + 99], bare);
    }
}

TEST(Cutout, LensBaresADisc)
{
    const auto pixels = cut({ui::Cutout::Shape::Disc, {34.5, 32.0}, 10.0});   // device (50, 25), radius 20
    EXPECT_EQ(pixels[100 * 25 + 50], bare);
    EXPECT_EQ(pixels[100 * 25 + 29], covered);
    EXPECT_EQ(pixels[100 * 25 + 71], covered);
    EXPECT_EQ(pixels[100 * 8 + 50], bare);
    EXPECT_EQ(pixels[100 * 3 + 50], covered);
    EXPECT_EQ(pixels[100 * 8 + 66], covered);
}

TEST(Cutout, OffTheCanvasChangesNothingOrEverything)
{
    EXPECT_EQ(cut({ui::Cutout::Shape::RightOf, {500.0, 0.0}, 0.0}), std::vector<std::uint32_t>(100 * 50, covered));
    EXPECT_EQ(cut({ui::Cutout::Shape::Disc, {-400.0, 30.0}, 10.0}), std::vector<std::uint32_t>(100 * 50, covered));
}

}   // namespace
