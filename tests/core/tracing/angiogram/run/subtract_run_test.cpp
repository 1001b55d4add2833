#include "core/tracing/angiogram/run/subtract_run.h"

#include "core/tracing/angiogram/trace_angiogram.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <functional>

using namespace angiopose;

namespace {

using core::ImageF;
using core::Polarity;

const test::Path contrastVessel = test::line({20, 30}, {180, 120});

/// A frame with ribs as dark as the vessel, which is opacified or not; the patient has moved by `driftPx`.
ImageF ribFrame(bool isOpacified, double driftPx, std::uint64_t seed)
{
    std::vector<test::Path> bars;
    for (const double x : {40.0, 90.0, 150.0}) {
        bars.push_back(test::line({x + driftPx, -20.0}, {x - 25.0 + driftPx, 170.0}));
    }
    bars.push_back(test::line({-20.0, 60.0 + 0.5 * driftPx}, {220.0, 20.0 + 0.5 * driftPx}));
    ImageF frame = test::drawnFrame(200, 150, bars, 5.0, {.background = 900.0F, .depth = 300.0F});
    if (isOpacified) {
        const ImageF shadow = test::drawnFrame(200, 150, {contrastVessel}, 3.0, {.background = 1.0F, .depth = 0.25F});
        std::transform(frame.pixels.begin(), frame.pixels.end(), shadow.pixels.begin(), frame.pixels.begin(),
                       std::multiplies<>());
    }
    test::addNoise(frame, 10.0, seed);
    return frame;
}

/// Created on first use, because every test of this program runs in its own process.
const std::vector<ImageF>& ribRun()
{
    static const std::vector<ImageF> run{ribFrame(false, 0.0, 1), ribFrame(false, 0.2, 2), ribFrame(true, 1.5, 3),
                                         ribFrame(true, 2.1, 4)};
    return run;
}

TEST(SubtractRun, LeavesTheVesselAlone)
{
    const auto subtracted = core::subtractRun(ribRun(), Polarity::VesselsDark, {.maskFrames = {0, 1}});
    ASSERT_TRUE(subtracted) << subtracted.error().message;
    ASSERT_EQ(subtracted.value().frames.size(), 4U);
    EXPECT_NEAR(subtracted.value().maskShiftsPx[2].x(), 1.4, 0.15);
    const auto trace = core::traceAngiogram(subtracted.value().frames[2], Polarity::VesselsDark);
    ASSERT_TRUE(trace) << trace.error().message;
    double found = 0.0;
    for (const core::Curve2d& curve : trace.value().centerline.curves) {
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            EXPECT_LT(test::distanceTo(contrastVessel, point), 3.0) << "a rib";
        }
        found += curve.lengthPx();
    }
    EXPECT_GT(found, 165.0);
}

/// Frames of one gray value each, so that a difference identifies the mask frame.
std::vector<ImageF> steps(int count)
{
    std::vector<ImageF> frames;
    for (int i = 0; i < count; ++i) {
        frames.emplace_back(20, 10, 100.0F + static_cast<float>(i * i));
    }
    return frames;
}

float differenceAt(const core::SubtractedRun& subtracted, const std::vector<ImageF>& frames, int frame)
{
    const auto i = static_cast<std::size_t>(frame);
    return subtracted.frames[i].pixels.front() -
           frames[i].pixels.front();   // the middle gray value of the frame is added back
}

TEST(SubtractRun, AnIntervalTakesTheFrameBefore)
{
    const std::vector<ImageF> frames = steps(6);
    const core::SubtractionPlan plan{.maskFrames = {},
                                     .interval = core::MaskInterval{2, std::nullopt},
                                     .maskShiftPx = Eigen::Vector2d(0.0, 0.0),
                                     .relation = core::PixelRelation::Logarithmic};
    const auto result = core::subtractRun(frames, Polarity::VesselsDark, plan);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(differenceAt(result.value(), frames, 1), 0.0F) << "no frame lies two before it: stays as it is";
    EXPECT_FLOAT_EQ(differenceAt(result.value(), frames, 3), 9.0F - 1.0F);
    EXPECT_FLOAT_EQ(differenceAt(result.value(), frames, 5), 25.0F - 9.0F);
}

TEST(SubtractRun, AReversedIntervalWalksBackwards)
{
    // DICOM rule: mask = (first contrast frame - offset) - (frame - first contrast frame).
    const std::vector<ImageF> frames = steps(8);
    const core::SubtractionPlan plan{.maskFrames = {},
                                     .interval = core::MaskInterval{1, 4},
                                     .maskShiftPx = Eigen::Vector2d(0.0, 0.0),
                                     .relation = core::PixelRelation::Logarithmic};
    const auto result = core::subtractRun(frames, Polarity::VesselsDark, plan);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_FLOAT_EQ(differenceAt(result.value(), frames, 4), 16.0F - 9.0F);
    EXPECT_FLOAT_EQ(differenceAt(result.value(), frames, 6), 36.0F - 1.0F);
    EXPECT_EQ(differenceAt(result.value(), frames, 2), 0.0F) << "before the range";
}

TEST(SubtractRun, OneFrameIsAsInTheRun)
{
    const core::SubtractionPlan plan{.maskFrames = {0, 1}};
    const auto whole = core::subtractRun(ribRun(), Polarity::VesselsDark, plan);
    const auto one = core::subtractFrame(ribRun(), Polarity::VesselsDark, plan, 2);
    ASSERT_TRUE(whole && one);
    EXPECT_EQ(one.value().frame.pixels, whole.value().frames[2].pixels);
    EXPECT_EQ(one.value().maskShiftPx, whole.value().maskShiftsPx[2]);
}

TEST(TreatedRun, CompositeShowsAllContrastInEveryFrame)
{
    core::Angiogram stored;
    stored.frames = ribRun();
    core::RunProcessing processing{.isSubtracted = true, .isComposite = true, .plan = {.maskFrames = {0, 1}}};
    const auto treated = core::processRun(stored, processing);
    ASSERT_TRUE(treated) << treated.error().message;
    ASSERT_EQ(treated.value().frameCount(), stored.frameCount());
    EXPECT_EQ(treated.value().frames[0].pixels, treated.value().frames[3].pixels);
    const auto subtracted = core::subtractRun(ribRun(), Polarity::VesselsDark, processing.plan);
    for (std::size_t i = 0; i < 200; ++i) {
        EXPECT_LE(treated.value().frames[0].pixels[i], subtracted.value().frames[2].pixels[i]);
    }
}

TEST(SubtractRun, StopsWhenAsked)
{
    EXPECT_FALSE(core::subtractRun(ribRun(), Polarity::VesselsDark, {.maskFrames = {0}}, [] { return true; }));
}

TEST(SubtractRun, AShiftByHandIsTaken)
{
    const Eigen::Vector2d byHand(0.5, -1.0);
    const auto subtracted =
        core::subtractRun(ribRun(), Polarity::VesselsDark, {.maskFrames = {0}, .maskShiftPx = byHand});
    ASSERT_TRUE(subtracted);
    EXPECT_EQ(subtracted.value().maskShiftsPx, std::vector<Eigen::Vector2d>(4, byHand));
}

/// If bones are much darker than the vessels, all frames have a similar number of ridges.
TEST(SuggestMaskFrames, TracingTellsWhetherTheFirstFrameShowsContrast)
{
    std::vector<test::Path> vessels(2);
    for (double x = 20.0; x < 380.0; x += 1.0) {
        vessels[0].emplace_back(x, 130.0 + 40.0 * std::sin(0.03 * x));
        vessels[1].emplace_back(x, 280.0 + 40.0 * std::sin(0.04 * x));
    }
    std::vector<test::Path> bones;
    for (double x = 15.0; x < 400.0; x += 50.0) {
        bones.push_back(test::line({x, -20.0}, {x, 420.0}));
    }
    std::vector<ImageF> frames;
    for (std::uint64_t k = 0; k < 5; ++k) {
        ImageF frame = test::drawnFrame(400, 400, bones, 4.0, {.background = 900.0F, .depth = 200.0F});
        const ImageF shadow =
            test::drawnFrame(400, 400, vessels, 3.0, {.background = 1.0F, .depth = k < 2 ? 0.0F : 0.4F});
        std::ranges::transform(frame.pixels, shadow.pixels, frame.pixels.begin(), std::multiplies<>());
        test::addNoise(frame, 8.0, k + 1);
        frames.push_back(std::move(frame));
    }
    EXPECT_EQ(core::suggestMaskFrames(frames, Polarity::VesselsDark), std::vector<int>{0});
    frames.erase(frames.begin(), frames.begin() + 2);
    EXPECT_TRUE(core::suggestMaskFrames(frames, Polarity::VesselsDark).empty()) << "filled from the first frame on";
}

TEST(SubtractRun, RefusesInPlainWords)
{
    const auto missing = core::subtractRun(ribRun(), Polarity::VesselsDark, {.maskFrames = {9}});
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().message.text().find("frames 1 to 4"), std::string::npos);
    EXPECT_FALSE(core::subtractRun({ribRun()[0]}, Polarity::VesselsDark, {.maskFrames = {0}}));
    EXPECT_FALSE(core::subtractRun({ribRun()[0], ImageF(3, 3)}, Polarity::VesselsDark, {.maskFrames = {0}}));
    const std::vector<ImageF> filled{ribFrame(true, 0.0, 5), ribFrame(true, 0.0, 6)};
    EXPECT_FALSE(core::subtractRun(filled, Polarity::VesselsDark, {})) << "contrast from the first frame on";
}

TEST(SubtractRun, AFrameThatShowsNothingIsNeitherMaskNorSubtractedFrom)
{
    std::vector<ImageF> frames = ribRun();
    std::ranges::fill(frames[0].pixels, 1200.0F);
    std::ranges::fill(frames[3].pixels, 1200.0F);
    const auto subtracted = core::subtractRun(frames, Polarity::VesselsDark, {.maskFrames = {0, 1}});
    ASSERT_TRUE(subtracted) << subtracted.error().message;
    EXPECT_EQ(subtracted.value().maskFrames, std::vector<int>{1});
    EXPECT_EQ(subtracted.value().frames[3].pixels, frames[3].pixels);
}

TEST(SuggestMaskFrames, AreThoseBeforeTheContrastArrives)
{
    std::vector<ImageF> plain;
    for (int k = 0; k < 6; ++k) {
        const std::vector<test::Path> filled(k < 2 ? 0 : 1, contrastVessel);
        plain.push_back(test::drawnFrame(160, 120, filled, 3.0, {.noise = 4.0}));
    }
    EXPECT_EQ(core::suggestMaskFrames(plain, Polarity::VesselsDark), (std::vector<int>{0, 1}));
    EXPECT_TRUE(core::suggestMaskFrames({}, Polarity::VesselsDark).empty());
    std::ranges::fill(plain[0].pixels, 1000.0F);   // a frame without any content
    EXPECT_EQ(core::suggestMaskFrames(plain, Polarity::VesselsDark), std::vector<int>{1});
}

}   // namespace
