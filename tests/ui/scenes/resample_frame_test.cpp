#include "ui/scenes/resample_frame.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>

#include <vector>

using namespace angiopose;

namespace {

using Gray = core::Image2d<std::uint8_t>;

std::vector<int> resampled(const Gray& gray, const ui::ViewRect& rect, ui::Interpolation interpolation, int width,
                           int height)
{
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(width * height));
    ui::resampleFrame(gray, rect, interpolation, {0, 0, 0}, {pixels.data(), width, height});
    std::vector<int> values;
    for (const std::uint32_t pixel : pixels) {
        EXPECT_EQ(pixel >> 24U, 0xFFU);
        values.push_back(static_cast<int>(pixel & 0xFFU));
    }
    return values;
}

Gray rampFrame(int width, int height)
{
    Gray gray(width, height);
    test::forEachPixel(width, height, [&](int x, int y) { gray.at(x, y) = static_cast<std::uint8_t>(2 * x + 3 * y); });
    return gray;
}

TEST(ResampleFrame, KeepsEveryPixelAtScaleOne)
{
    const Gray gray = rampFrame(13, 9);
    for (const auto interpolation : {ui::Interpolation::Smooth, ui::Interpolation::Nearest}) {
        const auto values = resampled(gray, {-0.5, 12.5, -0.5, 8.5}, interpolation, 13, 9);
        for (std::size_t i = 0; i < values.size(); ++i) {
            EXPECT_EQ(values[i], gray.pixels[i]);
        }
    }
}

TEST(ResampleFrame, PutsAPlaneWhereItBelongsAtAnyZoom)
{
    const Gray gray = rampFrame(40, 30);
    for (const double zoom : {0.37, 0.8, 1.7, 5.3}) {
        const ui::ViewRect rect{5.2, 30.7, 6.1, 22.9};
        const int width = static_cast<int>(rect.width() * zoom);
        const int height = static_cast<int>(rect.height() * zoom);
        const auto values = resampled(gray, rect, ui::Interpolation::Smooth, width, height);
        test::forEachPixel(width, height, [&](int x, int y) {
            const double u = rect.left + (x + 0.5) * rect.width() / width;
            const double v = rect.top + (y + 0.5) * rect.height() / height;
            EXPECT_NEAR(values[static_cast<std::size_t>(y * width + x)], 2.0 * u + 3.0 * v, 1.0) << zoom;
        });
    }
}

TEST(ResampleFrame, CountsEveryPixelWhenItShrinks)
{
    Gray stripes(240, 240);
    test::forEachPixel(240, 240, [&](int x, int y) { stripes.at(x, y) = x % 2 == 0 ? 0 : 200; });
    for (const int value : resampled(stripes, {19.5, 219.5, 19.5, 219.5}, ui::Interpolation::Smooth, 40, 40)) {
        EXPECT_NEAR(value, 100, 5);
    }
}

TEST(ResampleFrame, EndsAtThePicturesEdge)
{
    const Gray gray(4, 4, 90);
    const auto values = resampled(gray, {-4.5, 7.5, -4.5, 7.5}, ui::Interpolation::Smooth, 12, 12);
    test::forEachPixel(12, 12, [&](int x, int y) {
        const bool isInside = x >= 4 && x < 8 && y >= 4 && y < 8;
        EXPECT_EQ(values[static_cast<std::size_t>(y * 12 + x)], isInside ? 90 : 0);
    });
}

}   // namespace
