#include "core/imaging/display_range.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>
#include <limits>

using namespace angiopose;

namespace {

using namespace core;

/// A ramp from 100 to 200 inside a black border.
ImageF borderedRamp()
{
    ImageF image(120, 100, 0.0F);
    test::forEachPixel({20, 20}, {120, 80},
                       [&](int x, int y) { image.at(x, y) = 100.0F + static_cast<float>(x - 20); });
    return image;
}

TEST(DisplayRange, IgnoresABlackBorder)
{
    const DisplayRange range = displayRange(borderedRamp());
    EXPECT_GE(range.low, 100.0);
    EXPECT_LE(range.low, 120.0);
    EXPECT_GE(range.high, 195.0);
}

TEST(DisplayRange, KeepsTheBackgroundGrayWhereVesselsAreThin)
{
    for (const float vessel : {20.0F, 180.0F}) {
        ImageF image(100, 100, 100.0F);
        for (int y = 0; y < 100; ++y) {
            image.at(40, y) = vessel;
            image.at(41, y) = vessel;
        }
        const DisplayRange range = displayRange(image);
        const double shade = (100.0 - range.low) / range.window();
        EXPECT_GT(shade, 0.35);
        EXPECT_LT(shade, 0.65);
    }
}

TEST(DisplayRange, IsNeverEmptyWhateverTheImage)
{
    for (const float value : {0.0F, 7.0F, std::numeric_limits<float>::quiet_NaN()}) {
        const DisplayRange range = displayRange(ImageF(10, 10, value));
        EXPECT_GT(range.window(), 0.0);
    }
    EXPECT_GT(displayRange(ImageF{}).window(), 0.0);
}

TEST(DisplayRange, OfTheVesselsEndsAtTheBackground)
{
    ImageF image(100, 100, 100.0F);
    for (int y = 0; y < 100; ++y) {
        image.at(40, y) = 60.0F;
        image.at(70, y) = 180.0F;   // a catheter, which is brighter than the background
    }
    const DisplayRange dark = vesselRange(image, Polarity::VesselsDark);
    EXPECT_EQ(dark.low, 60.0);
    EXPECT_EQ(dark.high, 100.0);
    const DisplayRange bright = vesselRange(image, Polarity::VesselsBright);
    EXPECT_EQ(bright.low, 100.0);
    EXPECT_EQ(bright.high, 180.0);
    EXPECT_GT(vesselRange(ImageF(10, 10, 7.0F), Polarity::VesselsDark).window(), 0.0);
    EXPECT_GT(vesselRange(ImageF{}, Polarity::VesselsDark).window(), 0.0);
}

TEST(DisplayRange, KeepsATwoValuedImage)
{
    ImageF image(10, 10, 0.0F);
    for (int y = 0; y < 10; ++y) {
        image.at(3, y) = 9.0F;
    }
    const DisplayRange range = displayRange(image);
    EXPECT_GT(range.window(), 0.0);
}

}   // namespace
