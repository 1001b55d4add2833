#include "core/imaging/wide_gaussian_blur.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>
#include <numeric>

using namespace angiopose;

namespace {

using namespace core;

double variancePx(const ImageF& image, int center)
{
    double sum = 0.0;
    double squares = 0.0;
    test::forEachPixel(image.width, image.height, [&](int x, int y) {
        const double value = image.at(x, y);
        sum += value;
        squares += value * (x - center) * (x - center);
    });
    return squares / sum;
}

TEST(WideBlur, APointSpreadsByTheAskedSigma)
{
    for (const double sigma : {0.7, 2.0, 6.0, 15.0, 17.0}) {
        ImageF image(201, 201);
        image.at(100, 100) = 1.0F;
        const ImageF blurred = wideGaussianBlur(image, sigma);
        EXPECT_NEAR(variancePx(blurred, 100) / (sigma * sigma), 1.0, 0.07) << sigma;
        EXPECT_NEAR(std::accumulate(blurred.pixels.begin(), blurred.pixels.end(), 0.0), 1.0, 1e-3) << sigma;
    }
}

TEST(WideBlur, LeavesAFlatImageFlatUpToItsBorder)
{
    for (const double sigma : {1.0, 30.0}) {
        const ImageF blurred = wideGaussianBlur(ImageF(40, 25, 7.0F), sigma);
        for (const float value : blurred.pixels) {
            EXPECT_NEAR(value, 7.0F, 1e-4) << sigma;
        }
    }
}

TEST(WideBlur, ZeroSigmaChangesNothing)
{
    ImageF image(3, 2);
    image.at(1, 1) = 5.0F;
    EXPECT_EQ(wideGaussianBlur(image, 0.0).pixels, image.pixels);
}

}   // namespace
