#include "core/tracing/angiogram/frame/burned_in_text.h"

#include "core/tracing/angiogram/trace_angiogram.h"
#include "tests/support/drawn_letters.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using core::ImageF;
using core::Mask2d;

ImageF angiogram()
{
    return test::drawnFrame(300, 300, {test::line({40, 60}, {260, 280}), test::line({40, 250}, {200, 90})}, 3.0,
                            {.noise = 3.0});
}

TEST(BurnedInText, IsFoundAndTheVesselsAreNot)
{
    for (const float ink : {255.0F, 0.0F}) {
        ImageF frame = angiogram();
        test::writeLetters(frame, {170, 20}, 7, ink);
        const Mask2d text = core::burnedInTextMask(frame);
        for (int y = 20; y < 34; ++y) {
            for (int x = 170; x < 170 + 7 * 14 - 4; ++x) {
                ASSERT_NE(text.at(x, y), 0) << x << ' ' << y;
            }
        }
        EXPECT_LT(std::count(text.pixels.begin(), text.pixels.end(), 255), 120 * 40);
    }
}

TEST(BurnedInText, IsFoundWhereOtherThingsAreAsBrightOrDark)
{
    for (const float ink : {180.0F, 60.0F}) {
        ImageF frame = angiogram();
        frame.at(5, 5) = 255.0F;
        frame.at(9, 9) = 0.0F;
        test::writeLetters(frame, {170, 20}, 7, ink);
        const Mask2d text = core::burnedInTextMask(frame);
        EXPECT_NE(text.at(172, 22), 0) << ink;
        EXPECT_NE(text.at(256, 33), 0) << ink;
        EXPECT_LT(std::count(text.pixels.begin(), text.pixels.end(), 255), 120 * 40);
    }
}

TEST(BurnedInText, LargeLettersAreFoundWhereTheyAreLookedFor)
{
    for (const int scale : {3, 5, 6}) {   // 21 to 42 px of 300 px
        ImageF frame = angiogram();
        test::writeLetters(frame, {20, 20}, 4, 255.0F, scale);
        const Mask2d text = core::burnedInTextMask(frame, core::thoroughMaxLetterHeight);
        EXPECT_NE(text.at(21, 21), 0) << scale;
        EXPECT_NE(text.at(20 + 3 * 7 * scale + 1, 20 + 6 * scale), 0) << scale;
        const Mask2d usual = core::burnedInTextMask(frame);
        EXPECT_EQ(usual.at(21, 21), 0) << scale << ": what is traced stays as it was";
    }
    const Mask2d none = core::burnedInTextMask(angiogram(), core::thoroughMaxLetterHeight);
    EXPECT_EQ(std::count(none.pixels.begin(), none.pixels.end(), 255), 0);
}

TEST(BurnedInText, NothingIsFoundInAPlainAngiogram)
{
    const Mask2d text = core::burnedInTextMask(angiogram());
    EXPECT_EQ(std::count(text.pixels.begin(), text.pixels.end(), 255), 0);
    EXPECT_TRUE(core::burnedInTextMask({}).isEmpty());
    EXPECT_EQ(core::burnedInTextMask(ImageF(5, 5, 3.0F)).pixels, Mask2d(5, 5).pixels);
}

TEST(BurnedInText, IsKeptOutOfTheTrace)
{
    ImageF frame = angiogram();
    test::writeLetters(frame, {150, 16}, 9, 255.0F);
    test::writeLetters(frame, {150, 40}, 9, 255.0F);
    const auto trace = core::traceAngiogram(frame, core::Polarity::VesselsDark);
    ASSERT_TRUE(trace) << trace.error().message;
    EXPECT_EQ(trace.value().fieldMask.at(155, 22), 0);
    for (const core::Curve2d& curve : trace.value().centerline.curves) {
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            EXPECT_FALSE(point.x() > 140.0 && point.y() < 60.0);
        }
    }
}

}   // namespace
