#include "core/tracing/angiogram/frame/drawn_mask.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

ImageF bar(float ground, float vessel, float edge)
{
    ImageF picture(100, 100, ground);
    for (int y = 0; y < 100; ++y) {
        picture.at(49, y) = edge;
        picture.at(50, y) = picture.at(51, y) = picture.at(52, y) = vessel;
    }
    return picture;
}

TEST(DrawnMask, TakesTwoLevelsWithSmoothedEdges)
{
    const auto mask = vesselMaskFromDrawing(bar(0.0F, 255.0F, 140.0F));
    ASSERT_TRUE(mask);
    EXPECT_EQ(mask->at(48, 10), 0);
    EXPECT_EQ(mask->at(49, 10), 255);
    EXPECT_EQ(mask->at(52, 99), 255);
}

TEST(DrawnMask, LeavesPicturesAlone)
{
    EXPECT_FALSE(vesselMaskFromDrawing(bar(255.0F, 0.0F, 140.0F))) << "dark vessels on white: a picture";
    EXPECT_FALSE(vesselMaskFromDrawing(ImageF(20, 20, 7.0F))) << "one level";
    EXPECT_FALSE(vesselMaskFromDrawing(ImageF()));
    ImageF gray(100, 100);
    for (std::size_t i = 0; i < gray.pixels.size(); ++i) {
        gray.pixels[i] = static_cast<float>(i % 100);
    }
    EXPECT_FALSE(vesselMaskFromDrawing(gray));
}

}   // namespace
}   // namespace angiopose::core
