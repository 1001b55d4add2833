#include "core/tracing/angiogram/curves/misregistered_edge.h"

#include "core/tracing/angiogram/trace_angiogram.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using test::Path;

const Path edgeVessel = test::line({60.0, 20.0}, {140.0, 230.0});
const Path edge = test::line({40.0, 160.0}, {215.0, 100.0});

/// A vessel and a bone edge that was 3 px higher in the mask image, or the same edge without a bright band next to it.
core::ImageF frameWithMovedEdge(bool hasBrightSide)
{
    core::ImageF frame = test::drawnFrame(256, 256, {edgeVessel}, 3.0);
    const auto add = [&](const Path& path, float sign) {
        const core::ImageF line = test::drawnFrame(256, 256, {path}, 1.5, {.depth = 30.0F});
        for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
            frame.pixels[i] += sign * (line.pixels[i] - 120.0F);
        }
    };
    add(edge, 1.0F);
    if (hasBrightSide) {
        add({edge.front() - Eigen::Vector2d(0.0, 3.0), edge.back() - Eigen::Vector2d(0.0, 3.0)}, -1.0F);
    }
    test::addNoise(frame, 3.0, 7);
    return frame;
}

double lengthNear(const core::Centerline2d& centerline, const Path& path)
{
    double length = 0.0;
    for (const core::Curve2d& curve : core::resampled(centerline, 1.0).curves) {
        length += static_cast<double>(std::ranges::count_if(
            curve.pointsPx, [&](const Eigen::Vector2d& point) { return test::distanceTo(path, point) < 3.0; }));
    }
    return length;
}

TEST(MovedEdge, IsNoVesselBesideItsBrightSide)
{
    const auto trace = core::traceAngiogram(frameWithMovedEdge(true), core::Polarity::VesselsDark);
    ASSERT_TRUE(trace) << trace.error().message;
    EXPECT_GT(lengthNear(trace.value().centerline, edgeVessel), 210.0);
    EXPECT_LT(lengthNear(trace.value().centerline, edge), 30.0) << "but for the crossing";
}

TEST(MovedEdge, IsAVesselForAllThatCanBeSeenWithoutIt)
{
    const auto trace = core::traceAngiogram(frameWithMovedEdge(false), core::Polarity::VesselsDark);
    ASSERT_TRUE(trace) << trace.error().message;
    EXPECT_GT(lengthNear(trace.value().centerline, edge), 170.0);
}

TEST(MovedEdge, IsNotToldFromAFewPixels)
{
    core::ImageF opacity(20, 20);
    for (int x = 0; x < 20; ++x) {
        opacity.at(x, 10) = 5.0F;
        opacity.at(x, 13) = -9.0F;
    }
    std::vector<Eigen::Vector2d> path;
    for (int x = 2; x < 18; ++x) {
        path.emplace_back(x, 10.0);
    }
    EXPECT_TRUE(core::isMisregisteredEdge(path, opacity));
    EXPECT_FALSE(core::isMisregisteredEdge({path.begin(), path.begin() + 5}, opacity));
    EXPECT_FALSE(core::isMisregisteredEdge({}, opacity));
}

}   // namespace
