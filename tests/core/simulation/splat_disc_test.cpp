#include "core/simulation/splat_disc.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

using namespace angiopose;

namespace {

using namespace core;

TEST(SplatDisc, HasTheVolumeAndTheCenterOfTheDisc)
{
    for (const double radius : {0.3, 0.8, 2.0, 5.5}) {
        for (const double fraction : {0.0, 0.25, 0.5, 0.9}) {
            ImageF image(32, 32);
            splatDisc(image, {15.0 + fraction, 16.0 - fraction}, radius, 2.0);
            double volume = 0.0;
            Eigen::Vector2d center = Eigen::Vector2d::Zero();
            test::forEachPixel(32, 32, [&](int x, int y) {
                volume += image.at(x, y);
                center += image.at(x, y) * Eigen::Vector2d(x, y);
            });
            EXPECT_NEAR(volume, 2.0 * std::numbers::pi * radius * radius, 1e-4 * volume);
            EXPECT_LT((center / volume - Eigen::Vector2d(15.0 + fraction, 16.0 - fraction)).norm(), 0.15) << radius;
        }
    }
}

TEST(SplatDisc, OutsideTheImageNothingHappens)
{
    ImageF image(8, 8);
    splatDisc(image, {-20.0, 4.0}, 3.0, 1.0);
    splatDisc(image, {4.0, 1e9}, 3.0, 1.0);
    EXPECT_EQ(std::accumulate(image.pixels.begin(), image.pixels.end(), 0.0F), 0.0F);
    splatDisc(image, {0.0, 0.0}, 3.0, 1.0);   // partly outside
    EXPECT_GT(image.at(0, 0), 0.9F);
}

}   // namespace
