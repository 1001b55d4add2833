#include "core/tracing/angiogram/frame/denoise_frame.h"

#include "core/tracing/angiogram/trace_angiogram.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

using namespace angiopose;

namespace {

using core::ImageF;

constexpr double noiseSigma = 8.0;

/// The same vessel with another noise seed; it ends at `reach` of its length and is `shiftPx` lower.
ImageF noisyFrame(std::uint64_t seed, double reach = 1.0, double shiftPx = 0.0)
{
    const Eigen::Vector2d start(20.0, 30.0 + shiftPx);
    ImageF frame = test::drawnFrame(256, 220, {test::line(start, start + reach * Eigen::Vector2d(210.0, 150.0))}, 3.5);
    test::addNoise(frame, noiseSigma, seed);
    return frame;
}

double rmsBetween(const ImageF& a, const ImageF& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        sum += std::pow(a.pixels[i] - b.pixels[i], 2);
    }
    return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

TEST(SteadyFrame, AveragesWhatStandsStill)
{
    const ImageF clean = test::drawnFrame(256, 220, {test::line({20, 30}, {230, 180})}, 3.5);
    std::vector<ImageF> run;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        run.push_back(noisyFrame(seed));
    }
    EXPECT_NEAR(rmsBetween(core::denoiseFrame(run, 6), clean), noiseSigma / 3.0,
                0.05 * noiseSigma);   // mean of nine frames
    EXPECT_NEAR(rmsBetween(core::denoiseFrame(run, 0), clean), noiseSigma / std::sqrt(5.0), 0.05 * noiseSigma);
}

TEST(SteadyFrame, TakesOutAChangeOfBrightness)
{
    std::vector<ImageF> run{noisyFrame(1), noisyFrame(2), noisyFrame(3)};
    for (float& value : run[2].pixels) {
        value += 30.0F;
    }
    double sum = 0.0;
    const ImageF steady = core::denoiseFrame(run, 1);
    for (std::size_t i = 0; i < steady.pixels.size(); ++i) {
        sum += steady.pixels[i] - run[1].pixels[i];
    }
    EXPECT_NEAR(sum / static_cast<double>(steady.pixels.size()), 0.0, 0.3);
}

TEST(SteadyFrame, LeavesAMovingVesselAsItIs)
{
    const std::vector<ImageF> run{noisyFrame(1, 1.0, -6.0), noisyFrame(2), noisyFrame(3, 1.0, 6.0)};
    EXPECT_EQ(core::denoiseFrame(run, 1).pixels, run[1].pixels);
}

TEST(SteadyFrame, WhatHasChangedTakesNoPart)
{
    std::vector<ImageF> run{noisyFrame(1, 0.9), noisyFrame(2)};   // less than one pixel in a hundred is newly opacified
    const ImageF steady = core::denoiseFrame(run, 1);
    EXPECT_NE(steady.pixels, run[1].pixels);
    int kept = 0;
    for (double along = 0.93; along < 0.99; along += 0.01) {
        const auto x = static_cast<int>(20.0 + along * 210.0);
        const auto y = static_cast<int>(30.0 + along * 150.0);
        kept += steady.at(x, y) == run[1].at(x, y) ? 1 : 0;
    }
    EXPECT_GE(kept, 5);
}

TEST(SteadyFrame, FramesThatDoNotFitAreLeftOut)
{
    ImageF notFinite = noisyFrame(3);
    notFinite.at(10, 10) = std::numeric_limits<float>::quiet_NaN();
    const ImageF other(100, 100, 5.0F);
    EXPECT_EQ(core::denoiseFrame({notFinite, noisyFrame(2), other}, 1).pixels, noisyFrame(2).pixels);
    EXPECT_EQ(core::denoiseFrame({ImageF()}, 0).pixels.size(), 0U);
}

TEST(SteadyFrame, LetsAFainterVesselBeTraced)
{
    test::FrameLook faint;
    faint.depth = 9.0F;
    core::Angiogram run;
    for (std::uint64_t seed = 1; seed <= 9; ++seed) {
        run.frames.push_back(test::drawnFrame(256, 220, {test::line({20, 30}, {230, 180})}, 3.0, faint));
        test::addNoise(run.frames.back(), noiseSigma, seed);
    }
    const auto lengthIn = [](const core::Result<core::AngiogramTrace>& trace) {
        return trace && !trace.value().centerline.curves.empty() ? trace.value().centerline.curves.front().lengthPx()
                                                                 : 0.0;
    };
    EXPECT_GT(lengthIn(core::traceFrame(run, 4)), 200.0);
    EXPECT_LT(lengthIn(core::traceAngiogram(run.frames[4], run.polarity)), 150.0);
    EXPECT_FALSE(core::traceFrame(run, 9));
}

}   // namespace
