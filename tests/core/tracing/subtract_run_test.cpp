#include "core/tracing/subtract_run.h"

#include "core/imaging/image_filters.h"
#include "core/tracing/trace_angiogram.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>
#include <algorithm>

namespace {

using core::ImageF;
using core::Polarity;

const test::Path vessel = test::line({20, 30}, {180, 120});

/// A frame with ribs as dark as the vessel, which is filled or not; the patient has moved by `driftPx`.
ImageF frameOf(bool isFilled, double driftPx, std::uint64_t seed)
{
    std::vector<test::Path> bars;
    for (const double x : {40.0, 90.0, 150.0}) {
        bars.push_back(test::line({x + driftPx, -20.0}, {x - 25.0 + driftPx, 170.0}));
    }
    bars.push_back(test::line({-20.0, 60.0 + 0.5 * driftPx}, {220.0, 20.0 + 0.5 * driftPx}));
    ImageF frame = test::drawnFrame(200, 150, bars, 5.0, {.background = 900.0F, .depth = 300.0F});
    if (isFilled) {
        const ImageF shadow = test::drawnFrame(200, 150, {vessel}, 3.0, {.background = 1.0F, .depth = 0.25F});
        std::transform(frame.pixels.begin(), frame.pixels.end(), shadow.pixels.begin(), frame.pixels.begin(),
                       std::multiplies<>());
    }
    test::addNoise(frame, 10.0, seed);
    return frame;
}

const std::vector<ImageF> run{frameOf(false, 0.0, 1), frameOf(false, 0.2, 2), frameOf(true, 1.5, 3),
                              frameOf(true, 2.1, 4)};

TEST(SubtractRun, LeavesTheVesselAlone)
{
    const auto subtracted = core::subtractRun(run, Polarity::VesselsDark, {.maskFrames = {0, 1}});
    ASSERT_TRUE(subtracted) << subtracted.error().message;
    ASSERT_EQ(subtracted.value().frames.size(), 4U);
    EXPECT_NEAR(subtracted.value().maskShiftsPx[2].x(), 1.4, 0.15);
    const auto trace = core::traceAngiogram(subtracted.value().frames[2], Polarity::VesselsDark);
    ASSERT_TRUE(trace) << trace.error().message;
    double found = 0.0;
    for (const core::Curve2d& curve : trace.value().centerline.curves) {
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            EXPECT_LT(test::distanceTo(vessel, point), 3.0) << "a rib";
        }
        found += curve.lengthPx();
    }
    EXPECT_GT(found, 165.0);
}

TEST(SubtractRun, AShiftByHandIsTaken)
{
    const Eigen::Vector2d byHand(0.5, -1.0);
    const auto subtracted = core::subtractRun(run, Polarity::VesselsDark, {.maskFrames = {0}, .maskShiftPx = byHand});
    ASSERT_TRUE(subtracted);
    EXPECT_EQ(subtracted.value().maskShiftsPx, std::vector<Eigen::Vector2d>(4, byHand));
}

TEST(SubtractRun, RefusesInPlainWords)
{
    const auto missing = core::subtractRun(run, Polarity::VesselsDark, {.maskFrames = {9}});
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().message.find("frames 0 to 3"), std::string::npos);
    EXPECT_FALSE(core::subtractRun({run[0]}, Polarity::VesselsDark, {.maskFrames = {0}}));
    EXPECT_FALSE(core::subtractRun({run[0], ImageF(3, 3)}, Polarity::VesselsDark, {.maskFrames = {0}}));
    const std::vector<ImageF> filled{frameOf(true, 0.0, 5), frameOf(true, 0.0, 6)};
    EXPECT_FALSE(core::subtractRun(filled, Polarity::VesselsDark, {})) << "contrast from the first frame on";
}

TEST(SuggestMaskFrames, AreThoseBeforeTheContrastArrives)
{
    std::vector<ImageF> plain;
    for (int k = 0; k < 6; ++k) {
        const std::vector<test::Path> filled(k < 2 ? 0 : 1, vessel);
        plain.push_back(test::drawnFrame(160, 120, filled, 3.0, {.noise = 4.0}));
    }
    EXPECT_EQ(core::suggestMaskFrames(plain, Polarity::VesselsDark), (std::vector<int>{0, 1}));
    EXPECT_TRUE(core::suggestMaskFrames({}, Polarity::VesselsDark).empty());
}

}   // namespace
