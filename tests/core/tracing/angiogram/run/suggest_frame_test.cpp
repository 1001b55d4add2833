#include "core/tracing/angiogram/run/suggest_frame.h"

#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using core::ImageF;
using core::Polarity;

/// A bolus: the vessel is opacified up to `reach` of its length.
ImageF frameFilledTo(double reach, double noise = 4.0)
{
    const Eigen::Vector2d start(20, 30);
    const Eigen::Vector2d end = start + reach * Eigen::Vector2d(210, 150);
    return test::drawnFrame(256, 220, {test::line(start, end)}, 3.5, {.noise = noise});
}

TEST(SuggestFrame, PicksThePeakOpacificationFrame)
{
    const std::vector<ImageF> run{frameFilledTo(0.1), frameFilledTo(0.4), frameFilledTo(1.0), frameFilledTo(0.6)};
    EXPECT_EQ(core::suggestFrame(run, Polarity::VesselsDark), 2);
    const std::vector<double> curve = core::opacificationCurve(run, Polarity::VesselsDark);
    ASSERT_EQ(curve.size(), 4U);
    EXPECT_LT(curve[0], curve[1]);
    EXPECT_LT(curve[1], curve[3]);
    EXPECT_LT(curve[3], curve[2]);
}

TEST(SuggestFrame, TakesTheMiddleOfALongFilling)
{
    const ImageF full = frameFilledTo(1.0);
    EXPECT_EQ(core::suggestFrame({frameFilledTo(0.3), full, full, full, full, full}, Polarity::VesselsDark), 3);
}

TEST(SuggestFrame, NoiseIsNotTakenForFilling)
{
    const std::vector<ImageF> run{frameFilledTo(0.2, 20.0), frameFilledTo(0.9, 4.0)};
    EXPECT_EQ(core::suggestFrame(run, Polarity::VesselsDark), 1);
}

TEST(SuggestFrame, UntraceableFramesCountAsEmpty)
{
    EXPECT_EQ(core::suggestFrame({}, Polarity::VesselsDark), 0);
    const std::vector<ImageF> run{frameFilledTo(0.5), ImageF(), ImageF(256, 220, 7.0F), ImageF(9, 9, 1.0F)};
    const std::vector<double> curve = core::opacificationCurve(run, Polarity::VesselsDark);
    EXPECT_GT(curve[0], 0.0);
    EXPECT_EQ(curve[1], 0.0);
    EXPECT_EQ(curve[2], 0.0);
    EXPECT_EQ(curve[3], 0.0);
}

}   // namespace
