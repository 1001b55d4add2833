#include "core/tracing/angiogram/frame/report_page.h"

#include "core/messages/messages.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "tests/support/drawn_letters.h"
#include "tests/support/drawn_vessels.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using core::ImageF;

void box(ImageF& page, int left, int top, int right, int bottom, float ink)
{
    for (int x = left; x <= right; ++x) {
        page.at(x, top) = page.at(x, bottom) = ink;
    }
    for (int y = top; y <= bottom; ++y) {
        page.at(left, y) = page.at(right, y) = ink;
    }
}

/// Twelve lines of text in a frame, as in a dose report.
ImageF page(float paper, float ink)
{
    ImageF page(512, 512, paper);
    for (int line = 0; line < 12; ++line) {
        test::writeLetters(page, {40, 40 + 36 * line}, 6 + line % 5, ink);
        test::writeLetters(page, {260, 40 + 36 * line}, 9 - line % 4, ink);
    }
    box(page, 20, 20, 490, 490, ink);
    box(page, 240, 20, 241, 490, ink);
    return page;
}

bool isRefused(const ImageF& frame)
{
    const auto trace = core::traceAngiogram(frame, core::Polarity::VesselsDark);
    return !trace && trace.error().message.is(core::messages::frameIsReportPage);
}

TEST(ReportPage, IsNoAngiogram)
{
    EXPECT_TRUE(core::isReportPage(page(255.0F, 0.0F)));
    EXPECT_TRUE(core::isReportPage(page(0.0F, 255.0F)));   // a drawn mask has just as few gray levels
    EXPECT_TRUE(core::isReportPage(page(200.0F, 30.0F)));
    EXPECT_TRUE(isRefused(page(0.0F, 255.0F)));
}

TEST(ReportPage, AngiogramsWithWordsInABlackFrameAreNone)
{
    ImageF frame(512, 512, 0.0F);   // a narrow field: a quarter of the image
    const ImageF field = test::drawnFrame(256, 256, {test::line({20, 40}, {240, 220})}, 3.0, {.noise = 3.0});
    test::forEachPixel(256, 256, [&](int x, int y) { frame.at(128 + x, 128 + y) = field.at(x, y); });
    for (int line = 0; line < 6; ++line) {
        test::writeLetters(frame, {10, 10 + 18 * line}, 8, 255.0F);
    }
    EXPECT_FALSE(core::isReportPage(frame));
    EXPECT_FALSE(isRefused(frame));
}

TEST(ReportPage, MasksAndSpecksAreNone)
{
    ImageF mask(300, 300, 0.0F);
    for (int x = 20; x < 280; ++x) {
        for (int y = 100; y < 106; ++y) {
            mask.at(x, y + x / 4) = 255.0F;
        }
    }
    EXPECT_FALSE(core::isReportPage(mask));
    for (int n = 0; n < 400; ++n) {   // a saturated image with noise
        mask.at((n * 97) % 290, (n * 61) % 290) = 255.0F;
        mask.at((n * 97) % 290 + 1, (n * 61) % 290 + 1) = 255.0F;
    }
    EXPECT_FALSE(core::isReportPage(mask));
    EXPECT_FALSE(core::isReportPage({}));
    EXPECT_FALSE(core::isReportPage(ImageF(64, 64, 7.0F)));
}

}   // namespace
