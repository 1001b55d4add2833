#include "core/tracing/angiogram/ridges/clutter_level.h"

#include "core/imaging/image_filters.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using core::ImageF;
using core::Mask2d;

ImageF noiseFrame(int width, int height, double sigma)
{
    ImageF image(width, height);
    test::addNoise(image, sigma, 11);
    return image;
}

core::ClutterEstimate measured(const ImageF& opacity)
{
    return {opacity, Mask2d(opacity.width, opacity.height, 255), core::ridgeScales(1.5, 8.0)};
}

double clutterOf(const ImageF& opacity)
{
    const core::ClutterEstimate clutter = measured(opacity);
    return clutter.level(core::ridgeStrength(opacity, clutter.scales()));
}

TEST(ClutterLevel, GrowsWithTheNoise)
{
    const double once = clutterOf(noiseFrame(200, 200, 2.0));
    EXPECT_GT(once, 0.0);
    EXPECT_NEAR(clutterOf(noiseFrame(200, 200, 6.0)), 3.0 * once, 0.01 * once);
}

TEST(ClutterLevel, DoesNotSeeTheVesselsThemselves)
{
    ImageF opacity = noiseFrame(200, 200, 2.0);
    const double without = clutterOf(opacity);
    const ImageF drawn =
        test::drawnFrame(200, 200, {test::line({10, 20}, {190, 150}), test::line({20, 180}, {180, 40})}, 3.0);
    for (std::size_t i = 0; i < opacity.pixels.size(); ++i) {
        opacity.pixels[i] += 120.0F - drawn.pixels[i];   // 30 times the noise
    }
    EXPECT_LT(clutterOf(opacity), 2.5 * without);   // the flanks of the vessels may give the finest scales more weight
}

TEST(ClutterLevel, BandsOfALargeImageStandForTheWhole)
{
    EXPECT_NEAR(clutterOf(noiseFrame(300, 700, 2.0)), clutterOf(noiseFrame(300, 300, 2.0)),
                0.05 * clutterOf(noiseFrame(300, 300, 2.0)));
}

TEST(ClutterLevel, IsNothingWithoutAField)
{
    const core::ClutterEstimate clutter(noiseFrame(60, 60, 2.0), Mask2d(60, 60), core::ridgeScales(1.5, 8.0));
    EXPECT_EQ(clutter.level(noiseFrame(60, 60, 2.0)), 0.0);
}

TEST(ClutterLevel, NoiseOfSinglePixelsTakesWeightFromTheFinestScales)
{
    const auto scales = measured(noiseFrame(300, 300, 4.0)).scales();
    EXPECT_LT(scales.front().weight, 0.7);
    EXPECT_EQ(scales.back().weight, 1.0);
}

TEST(ClutterLevel, StructuresOfAllSizesLeaveTheWeightsAlone)
{
    ImageF opacity = noiseFrame(300, 300, 1.0);
    for (const double sigmaPx : {1.5, 3.0, 6.0, 12.0}) {   // equal contrast at each size
        const ImageF coarser = core::gaussianBlur(noiseFrame(300, 300, 40.0 * sigmaPx), sigmaPx);
        for (std::size_t i = 0; i < opacity.pixels.size(); ++i) {
            opacity.pixels[i] += coarser.pixels[i];
        }
    }
    const std::vector<core::RidgeScale> scales = measured(opacity).scales();
    for (const core::RidgeScale& scale : scales) {
        EXPECT_GT(scale.weight, 0.75) << scale.sigmaPx;
    }
}

}   // namespace
