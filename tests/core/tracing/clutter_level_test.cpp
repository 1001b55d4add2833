#include "core/tracing/clutter_level.h"

#include "core/tracing/vesselness.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>

namespace {

using core::ImageF;
using core::Mask2d;

ImageF noise(int width, int height, double sigma)
{
    ImageF image(width, height);
    test::addNoise(image, sigma, 11);
    return image;
}

double clutterOf(const ImageF& opacity)
{
    const ImageF ridges = core::ridgeStrength(opacity, 1.5, 8.0);
    return core::clutterLevel(opacity, ridges, Mask2d(opacity.width, opacity.height, 255), 1.5, 8.0);
}

TEST(ClutterLevel, GrowsWithTheNoise)
{
    const double once = clutterOf(noise(200, 200, 2.0));
    EXPECT_GT(once, 0.0);
    EXPECT_NEAR(clutterOf(noise(200, 200, 6.0)), 3.0 * once, 0.01 * once);
}

TEST(ClutterLevel, DoesNotSeeTheVesselsThemselves)
{
    ImageF opacity = noise(200, 200, 2.0);
    const double without = clutterOf(opacity);
    const ImageF drawn =
        test::drawnFrame(200, 200, {test::line({10, 20}, {190, 150}), test::line({20, 180}, {180, 40})}, 3.0);
    for (std::size_t i = 0; i < opacity.pixels.size(); ++i) {
        opacity.pixels[i] += 120.0F - drawn.pixels[i];   // 30 times the noise
    }
    EXPECT_LT(clutterOf(opacity), 1.5 * without);
}

TEST(ClutterLevel, BandsOfALargeImageStandForTheWhole)
{
    EXPECT_NEAR(clutterOf(noise(300, 700, 2.0)), clutterOf(noise(300, 300, 2.0)),
                0.05 * clutterOf(noise(300, 300, 2.0)));
}

TEST(ClutterLevel, IsNothingWithoutAField)
{
    EXPECT_EQ(core::clutterLevel(noise(60, 60, 2.0), noise(60, 60, 2.0), Mask2d(60, 60), 1.5, 8.0), 0.0);
}

}   // namespace
