#include "core/tracing/angiogram/trace_angiogram.h"

#include "tests/support/drawn_vessels.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <limits>

using namespace angiopose;

namespace {

using core::AngiogramTrace;
using core::Centerline2d;
using core::Curve2d;
using core::ImageF;
using core::Polarity;
using core::Result;
using test::Path;

double totalLength(const Centerline2d& centerline)
{
    double length = 0.0;
    for (const Curve2d& curve : centerline.curves) {
        length += curve.lengthPx();
    }
    return length;
}

const Curve2d& longest(const Centerline2d& centerline)
{
    return *std::max_element(centerline.curves.begin(), centerline.curves.end(),
                             [](const Curve2d& a, const Curve2d& b) { return a.lengthPx() < b.lengthPx(); });
}

double meanDistance(const Centerline2d& centerline, const Path& path)
{
    double sum = 0.0;
    for (const Curve2d& curve : centerline.curves) {
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            sum += test::distanceTo(path, point);
        }
    }
    return sum / static_cast<double>(centerline.pointCount());
}

/// A straight path extended at both ends, to measure only the distance across it.
Path longer(const Path& path)
{
    const Eigen::Vector2d beyond = 20.0 * (path.back() - path.front()).normalized();
    return {path.front() - beyond, path.back() + beyond};
}

class TubeOfRadius : public testing::TestWithParam<double> {};

TEST_P(TubeOfRadius, IsCenteredMeasuredAndFoundInFullLength)
{
    const Path path = test::line({20.3, 40.7}, {180.6, 141.2});
    const ImageF frame = test::drawnFrame(200, 180, {path}, GetParam(), {.noise = 4.0});
    const Result<AngiogramTrace> trace = core::traceAngiogram(frame, Polarity::VesselsDark);
    ASSERT_TRUE(trace) << trace.error().message;
    const Centerline2d& found = trace.value().centerline;
    ASSERT_EQ(found.curves.size(), 1U);
    EXPECT_LT(meanDistance(found, longer(path)), 0.2);
    EXPECT_GT(totalLength(found), 189.2 - GetParam() - 3.0);
    EXPECT_LT(totalLength(found), 189.2 + 2.0 * GetParam() + 3.0) << "longer than the tube with its round caps";
    const Curve2d& curve = found.curves.front();
    ASSERT_EQ(curve.radiusPx.size(), curve.pointsPx.size());
    EXPECT_NEAR(curve.radiusPx[curve.radiusPx.size() / 2], GetParam(), 0.15 * GetParam() + 0.4);
}

INSTANTIATE_TEST_SUITE_P(AllWidths, TubeOfRadius, testing::Values(1.5, 2.5, 4.0, 6.0, 8.0));

TEST(TraceAngiogram, CurvesBiasIsBelowAFifthOfAPixel)
{
    const Path path = test::circle({100.4, 95.8}, 60.0);
    const ImageF frame = test::drawnFrame(200, 200, {path}, 4.0, {.noise = 3.0});
    const Result<AngiogramTrace> trace = core::traceAngiogram(frame, Polarity::VesselsDark);
    ASSERT_TRUE(trace) << trace.error().message;
    double radial = 0.0;
    const Curve2d& ring = longest(trace.value().centerline);
    for (const Eigen::Vector2d& point : ring.pointsPx) {
        radial += (point - Eigen::Vector2d(100.4, 95.8)).norm() - 60.0;
    }
    EXPECT_NEAR(radial / static_cast<double>(ring.pointsPx.size()), 0.0, 0.2);
    EXPECT_NEAR(totalLength(trace.value().centerline), 377.0, 8.0);
}

TEST(TraceAngiogram, FindsAFaintBranchBesideAStrongTrunk)
{
    const Path trunk = test::line({30, 20}, {170, 230});
    const Path branch = test::line({100, 125}, {230, 60});
    ImageF frame = test::drawnFrame(256, 256, {trunk}, 5.0, {.depth = 90.0F});
    const ImageF faint = test::drawnFrame(256, 256, {branch}, 1.5, {.depth = 9.0F});
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        frame.pixels[i] += faint.pixels[i] - 120.0F;
    }
    test::addNoise(frame, 3.0, 5);   // a third of the branch's contrast depth
    const Result<AngiogramTrace> trace = core::traceAngiogram(frame, Polarity::VesselsDark);
    ASSERT_TRUE(trace) << trace.error().message;
    const Path apart = test::line({120, 115}, {225, 62.5});
    for (int k = 0; k <= 10; ++k) {
        const Eigen::Vector2d point = apart.front() + 0.1 * k * (apart.back() - apart.front());
        double nearest = 1e9;
        for (const Curve2d& curve : trace.value().centerline.curves) {
            nearest = std::min(nearest, test::distanceTo(curve.pointsPx, point));
        }
        EXPECT_LT(nearest, 1.5) << k;
    }
}

TEST(TraceAngiogram, CrossingVesselsStayTwoStraightCurves)
{
    const Path rising = test::line({20, 150}, {180, 50});
    const Path falling = test::line({20, 50}, {180, 150});
    const ImageF frame = test::drawnFrame(200, 200, {rising, falling}, 3.0, {.noise = 2.0});
    const Result<AngiogramTrace> trace = core::traceAngiogram(frame, Polarity::VesselsDark);
    ASSERT_TRUE(trace) << trace.error().message;
    ASSERT_EQ(trace.value().centerline.curves.size(), 2U);
    for (const Curve2d& curve : trace.value().centerline.curves) {
        EXPECT_GT(curve.lengthPx(), 175.0);
        const bool rises = (curve.pointsPx.front() - curve.pointsPx.back()).prod() < 0.0;
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            EXPECT_LT(test::distanceTo(longer(rises ? rising : falling), point),
                      1.5);   // least accurate in the rounded ends
        }
    }
}

TEST(TraceAngiogram, BrightVesselsGiveTheCurvesOfInvertedDarkOnes)
{
    const ImageF dark = test::drawnFrame(160, 160, {test::line({20, 30}, {140, 120})}, 3.0, {.noise = 3.0});
    ImageF bright = dark;
    for (float& value : bright.pixels) {
        value = 255.0F - value;
    }
    const auto fromDark = core::traceAngiogram(dark, Polarity::VesselsDark);
    const auto fromBright = core::traceAngiogram(bright, Polarity::VesselsBright);
    ASSERT_TRUE(fromDark && fromBright);
    const Curve2d& a = longest(fromDark.value().centerline);
    const Curve2d& b = longest(fromBright.value().centerline);
    ASSERT_EQ(a.pointsPx.size(), b.pointsPx.size());
    for (std::size_t i = 0; i < a.pointsPx.size(); ++i) {
        EXPECT_LT((a.pointsPx[i] - b.pointsPx[i]).norm(), 0.02);
    }
}

TEST(TraceAngiogram, ShutterAndBlackBorderGiveNoCurves)
{
    const Path path = test::line({70, 80}, {190, 170});
    ImageF frame = test::drawnFrame(256, 256, {path}, 3.0);
    test::forEachPixel(frame.width, frame.height, [&](int x, int y) {
        const bool collimated = x < 30 || y < 22 || x > 230 || x + y < 80;
        frame.at(x, y) = collimated ? 12.0F : frame.at(x, y);
    });
    for (const double noise : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0}) {
        ImageF noisy = frame;
        test::addNoise(noisy, noise, 7);
        const auto trace = core::traceAngiogram(noisy, Polarity::VesselsDark);
        ASSERT_TRUE(trace) << trace.error().message;
        EXPECT_LT(meanDistance(trace.value().centerline, path), 0.3) << noise;   // and no spurs at its ends
        EXPECT_EQ(trace.value().fieldMask.at(5, 128), 0);
        EXPECT_NE(trace.value().fieldMask.at(128, 128), 0);
    }
}

/// A soft shadow containing lines lies beyond the shutter of the header; its edge looks like a vessel.
TEST(TraceAngiogram, NothingIsTracedOnOrBeyondTheShutter)
{
    const Path path = test::line({90, 80}, {200, 190});
    const ImageF frame = test::drawnFrame(
        256, 256, {path, test::line({40, 40}, {52, 210}), test::line({64, 30}, {64, 225})}, 3.0, {.noise = 2.0});
    core::Angiogram run;
    run.frames = {frame};
    const auto reaches = [&](double column) {
        const auto trace = core::traceFrame(run, 0);
        EXPECT_TRUE(trace);
        return std::ranges::any_of(trace.value().centerline.curves, [&](const Curve2d& curve) {
            return std::ranges::any_of(curve.pointsPx,
                                       [&](const Eigen::Vector2d& point) { return point.x() < column; });
        });
    };
    EXPECT_TRUE(reaches(70.0));
    run.shutter = core::Mask2d(256, 256, 255);
    for (int y = 0; y < 256; ++y) {
        std::fill_n(run.shutter.pixels.begin() + y * 256, 64, std::uint8_t{0});
    }
    EXPECT_FALSE(reaches(70.0));
    const auto trace = core::traceFrame(run, 0);
    EXPECT_LT(meanDistance(trace.value().centerline, path), 0.3);
    EXPECT_EQ(trace.value().fieldMask.at(63, 128), 0);
    EXPECT_NE(trace.value().fieldMask.at(72, 128), 0);
    EXPECT_EQ(trace.value().vesselMask.at(64, 128), 0);
}

TEST(TraceAngiogram, TheShutterFitsFramesOfAnySize)
{
    for (const int side : {150, 512, 1024}) {   // upsampled by 2, unchanged, downsampled by 2
        const double unit = side / 512.0;
        core::Angiogram run;
        run.frames = {test::drawnFrame(side, side,
                                       {test::line(unit * Eigen::Vector2d(200, 60), unit * Eigen::Vector2d(420, 440)),
                                        test::line(unit * Eigen::Vector2d(80, 20), unit * Eigen::Vector2d(100, 490))},
                                       5.0 * unit, {.noise = 2.0})};
        run.shutter = core::Mask2d(side, side, 255);
        for (int y = 0; y < side; ++y) {
            std::fill_n(run.shutter.pixels.begin() + y * side, side / 4, std::uint8_t{0});
        }
        const auto trace = core::traceFrame(run, 0);
        ASSERT_TRUE(trace) << side;
        for (const Curve2d& curve : trace.value().centerline.curves) {
            for (const Eigen::Vector2d& point : curve.pointsPx) {
                EXPECT_GT(point.x(), 0.25 * side) << side;
            }
        }
    }
}

TEST(TraceAngiogram, FindsAWideVesselInNoiseOfSinglePixels)
{
    const Path path = test::line({20, 30}, {230, 180});
    test::FrameLook faint;
    faint.depth = 16.0F;
    ImageF frame = test::drawnFrame(256, 220, {path}, 4.0, faint);
    test::addNoise(frame, 10.0, 3);
    const auto trace = core::traceAngiogram(frame, Polarity::VesselsDark);
    ASSERT_TRUE(trace) << trace.error().message;
    EXPECT_GT(longest(trace.value().centerline).lengthPx(), 200.0);
    EXPECT_LT(meanDistance(trace.value().centerline, path), 1.0);
}

TEST(TraceAngiogram, RefusesWhatCannotBeTracedInPlainWords)
{
    EXPECT_NE(core::traceAngiogram({}, Polarity::VesselsDark).error().message.text().find("empty"), std::string::npos);
    const ImageF plain(64, 64, 100.0F);
    EXPECT_NE(core::traceAngiogram(plain, Polarity::VesselsDark).error().message.text().find("the same gray value"),
              std::string::npos);
    ImageF broken = test::drawnFrame(64, 64, {test::line({5, 5}, {60, 60})}, 2.0);
    broken.at(10, 10) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(core::traceAngiogram(broken, Polarity::VesselsDark).error().message.text().find("not finite numbers"),
              std::string::npos);
}

TEST(TraceAngiogram, NoiseAloneShowsNothingLikeAVessel)
{
    ImageF noise(256, 256, 100.0F);
    test::addNoise(noise, 10.0, 3);
    const auto trace = core::traceAngiogram(noise, Polarity::VesselsDark);
    ASSERT_FALSE(trace);
    EXPECT_NE(trace.error().message.text().find("No vessel was found"), std::string::npos);
}

TEST(TraceAngiogram, TinyImagesFailCleanly)
{
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 3}, {1, 500}, {500, 1}, {2, 40}}) {
        ImageF tiny(width, height, 50.0F);
        tiny.pixels.front() = 10.0F;
        EXPECT_FALSE(core::traceAngiogram(tiny, Polarity::VesselsDark)) << width << "x" << height;
    }
}

TEST(TraceMask, FollowsADrawnRing)
{
    core::Mask2d mask(120, 120);
    const Path ring = test::circle({60, 60}, 40.0);
    test::forEachPixel(120, 120, [&](int x, int y) { mask.at(x, y) = test::distanceTo(ring, {x, y}) < 3.0 ? 1 : 0; });
    const Result<Centerline2d> found = core::traceMask(mask);
    ASSERT_TRUE(found) << found.error().message;
    ASSERT_EQ(found.value().curves.size(), 1U);
    EXPECT_NEAR(found.value().curves.front().lengthPx(), 251.3, 10.0);
    EXPECT_LT(meanDistance(found.value(), ring), 0.6);
}

TEST(TraceMask, EmptyMaskIsAnError)
{
    EXPECT_FALSE(core::traceMask(core::Mask2d(50, 50)));
    EXPECT_FALSE(core::traceMask(core::Mask2d()));
}

TEST(TraceAngiogram, TakesADrawnMaskAsItIsDrawn)
{
    ImageF drawn(120, 100, 0.0F);
    test::forEachPixel({57, 10}, {64, 90}, [&](int x, int y) { drawn.at(x, y) = 255.0F; });
    for (const Polarity polarity : {Polarity::VesselsDark, Polarity::VesselsBright}) {
        const auto trace = core::traceAngiogram(drawn, polarity);
        ASSERT_TRUE(trace) << trace.error().message;
        ASSERT_EQ(trace.value().centerline.curves.size(), 1U) << "one bar, not its two edges";
        for (const Eigen::Vector2d& point : trace.value().centerline.curves.front().pointsPx) {
            EXPECT_NEAR(point.x(), 60.0, 1.0);
        }
        EXPECT_EQ(trace.value().vesselMask.at(60, 50), 255);
        EXPECT_EQ(trace.value().vesselMask.at(70, 50), 0);
        EXPECT_EQ(trace.value().fieldMask.at(0, 0), 255) << "nothing is kept out";
    }
}

}   // namespace
