#include "core/tracing/angiogram/curves/earlier_structures.h"

#include "core/tracing/angiogram/trace_angiogram.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

using namespace angiopose;

namespace {

using core::Angiogram;
using core::Curve2d;
using core::ImageF;
using core::Polarity;

/// A winding path, whose shape alone does not distinguish a catheter from a vessel.
test::Path winding(double y)
{
    test::Path path;
    for (double x = 30.0; x <= 270.0; x += 1.0) {
        path.emplace_back(x, y + 9.0 * std::sin(0.05 * x));
    }
    return path;
}

const test::Path catheter = winding(80.0);
const test::Path vessel = winding(160.0);
const test::Path secondVessel = winding(230.0);

ImageF frameOf(const std::vector<test::Path>& paths, std::uint64_t seed)
{
    ImageF frame = test::drawnFrame(300, 300, paths, 3.0);
    test::addNoise(frame, 3.0, seed);
    return frame;
}

test::Path moved(test::Path path, double byPx)
{
    for (Eigen::Vector2d& point : path) {
        point.y() += byPx;
    }
    return path;
}

Curve2d curveAlong(int id, const test::Path& path)
{
    return {id, path, std::vector<double>(path.size(), 3.0)};
}

TEST(EarlierStructures, TellsTheCatheterFromTheVessel)
{
    const core::Centerline2d traced{{curveAlong(1, catheter), curveAlong(2, vessel), curveAlong(3, secondVessel)}};
    const ImageF before = frameOf({moved(catheter, 2.5)}, 1);
    const ImageF frame = frameOf({catheter, vessel, secondVessel}, 2);
    const auto shares = core::fractionsVisibleBefore(traced, frame, before, Polarity::VesselsDark);
    EXPECT_GT(shares[0], 0.95);
    EXPECT_LT(shares[1], 0.2);
    const auto seen = core::findEarlierStructures(traced, frame, before, Polarity::VesselsDark);
    EXPECT_EQ(seen.curveIds, std::vector<int>{1});
    EXPECT_FALSE(seen.isNearlyAll);
}

TEST(EarlierStructures, HoldsForBrightVesselsToo)
{
    const auto bright = [](ImageF frame) {
        for (float& value : frame.pixels) {
            value = -value;
        }
        return frame;
    };
    const core::Centerline2d traced{{curveAlong(1, catheter), curveAlong(2, vessel), curveAlong(3, secondVessel)}};
    const auto seen = core::findEarlierStructures(traced, bright(frameOf({catheter, vessel, secondVessel}, 2)),
                                                  bright(frameOf({catheter}, 1)), Polarity::VesselsBright);
    EXPECT_EQ(seen.curveIds, std::vector<int>{1});
}

Angiogram runOf(std::vector<ImageF> frames)
{
    Angiogram run;
    run.frames = std::move(frames);
    return run;
}

TEST(EarlierStructures, FlagsNothingWhereVesselsMayHaveBeenFilledBefore)
{
    const core::Centerline2d traced{{curveAlong(1, catheter), curveAlong(2, vessel)}};
    const auto seen = core::findEarlierStructures(traced, frameOf({catheter, vessel}, 2), frameOf({vessel}, 1),
                                                  Polarity::VesselsDark);
    EXPECT_TRUE(seen.curveIds.empty());
    EXPECT_FALSE(seen.isNearlyAll);
}

TEST(EarlierStructures, FlagsWhatWasThereBeforeTheContrast)
{
    const Angiogram run =
        runOf({frameOf({catheter}, 1), frameOf({catheter}, 2), frameOf({catheter, vessel, secondVessel}, 3)});
    const auto trace = core::traceFrame(run, 2);
    ASSERT_TRUE(trace) << trace.error().message;
    EXPECT_TRUE(trace.value().warnings.empty());
    for (const Curve2d& curve : trace.value().centerline.curves) {
        const bool isCatheter = curve.pointsPx[curve.pointsPx.size() / 2].y() < 120.0;
        EXPECT_EQ(std::ranges::find(trace.value().suspectCurves, curve.id) != trace.value().suspectCurves.end(),
                  isCatheter);
    }
}

TEST(EarlierStructures, SaysWhereNoContrastComes)
{
    const auto still = core::traceFrame(runOf({frameOf({catheter}, 1), frameOf({moved(catheter, 1.0)}, 2)}), 1);
    ASSERT_TRUE(still) << still.error().message;
    ASSERT_EQ(still.value().warnings.size(), 1U);
    EXPECT_EQ(still.value().warnings.front().id(), "frame.nothing-new");
    const auto first = core::traceFrame(runOf({frameOf({catheter}, 1), frameOf({catheter}, 2)}), 0);
    ASSERT_TRUE(first);
    EXPECT_TRUE(first.value().warnings.empty()) << "nothing comes before it";
}

/// Ten frames of a heart that beats by 6 px; two vessels are opacified from frame `firstFilled` on. The `things` stay
/// stationary.
Angiogram beatingRun(const std::vector<test::Path>& things, int firstFilled)
{
    std::vector<ImageF> frames;
    for (int k = 0; k < 10; ++k) {
        const double beat = 6.0 * std::sin(1.1 * k);
        std::vector<test::Path> paths = things;
        if (k >= firstFilled) {
            paths.push_back(moved(vessel, beat));
            paths.push_back(moved(secondVessel, beat));
        }
        frames.push_back(frameOf(paths, static_cast<std::uint64_t>(k) + 1));
    }
    return runOf(std::move(frames));
}

bool isSuspect(const core::AngiogramTrace& trace, const Curve2d& curve)
{
    return std::ranges::find(trace.suspectCurves, curve.id) != trace.suspectCurves.end();
}

TEST(StillCurves, AreThoseThatStandStillThroughTheRun)
{
    const Angiogram run = beatingRun({catheter}, 3);
    const double beat = 6.0 * std::sin(1.1 * 6);
    const core::Centerline2d traced{
        {curveAlong(1, catheter), curveAlong(2, moved(vessel, beat)), curveAlong(3, moved(secondVessel, beat))}};
    EXPECT_EQ(core::findStationaryCurves(traced, run.frames, 6, Polarity::VesselsDark), std::vector<int>{1});
    EXPECT_TRUE(core::findStationaryCurves(traced, {run.frames[5], run.frames[6]}, 1, Polarity::VesselsDark).empty())
        << "two frames tell nothing";
}

/// A lead that winds like a vessel, in runs that start before the contrast agent or with it.
TEST(StillCurves, AreSetApartWhileVesselsMove)
{
    for (const int firstFilled : {3, 0}) {
        const auto trace = core::traceFrame(beatingRun({catheter}, firstFilled), 6);
        ASSERT_TRUE(trace) << trace.error().message;
        EXPECT_FALSE(trace.value().isStationary);
        for (const Curve2d& curve : trace.value().centerline.curves) {
            EXPECT_EQ(isSuspect(trace.value(), curve), curve.pointsPx[curve.pointsPx.size() / 2].y() < 120.0)
                << firstFilled;
        }
    }
}

TEST(StillCurves, OfAPhantomThatStandsStillAreVessels)
{
    std::vector<ImageF> frames;
    for (std::uint64_t k = 1; k <= 8; ++k) {
        frames.push_back(frameOf({vessel, secondVessel}, k));
    }
    const auto trace = core::traceFrame(runOf(std::move(frames)), 5);
    ASSERT_TRUE(trace) << trace.error().message;
    EXPECT_TRUE(trace.value().suspectCurves.empty());
}

TEST(StillCurves, AloneShowNoContrast)
{
    const auto trace = core::traceFrame(beatingRun({catheter}, 3), 1);
    ASSERT_TRUE(trace) << trace.error().message;
    EXPECT_TRUE(trace.value().isStationary);
}

}   // namespace
