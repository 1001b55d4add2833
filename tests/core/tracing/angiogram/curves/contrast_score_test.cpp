#include "core/tracing/angiogram/curves/contrast_score.h"

#include "core/messages/messages.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr int sidePx = 256;

bool isKnown(const AngiogramTrace& trace)
{
    return std::ranges::any_of(
        trace.warnings, [](const Message& warning) { return warning.id() == messages::frameWithLittleContrast.id; });
}

/// A path that sways like a vessel, unlike the straight line or single arc of a device.
test::Path swung(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    test::Path path;
    const Eigen::Vector2d way = to - from;
    for (int k = 0; k <= 40; ++k) {
        const double s = k / 40.0;
        path.push_back(from + s * way + 0.09 * std::sin(9.0 * s) * Eigen::Vector2d(-way.y(), way.x()));
    }
    return path;
}

std::vector<test::Path> forkedVessels()
{
    return {swung({15, 138}, {120, 110}), swung({120, 110}, {230, 30}), swung({120, 110}, {235, 200}),
            swung({60, 128}, {110, 230})};
}

AngiogramTrace traced(const std::vector<test::Path>& paths, const test::FrameLook& look)
{
    auto trace = traceAngiogram(test::drawnFrame(sidePx, sidePx, paths, 3.0, look), Polarity::VesselsDark);
    EXPECT_TRUE(trace) << trace.error().message;
    return trace ? std::move(trace).value() : AngiogramTrace{};
}

TEST(ContrastSeen, FilledVesselsAreNotSpokenOf)
{
    EXPECT_FALSE(isKnown(traced(forkedVessels(), {.noise = 4.0})));
}

TEST(ContrastSeen, AShortPieceInNoiseIsReported)
{
    EXPECT_TRUE(isKnown(traced({test::line({100, 110}, {150, 140})}, {.noise = 4.0})));
}

TEST(ContrastSeen, CountsNoSuspects)
{
    ImageF vesselness(sidePx, sidePx);
    std::ranges::fill(vesselness.pixels, 0.5F);
    const Centerline2d curves{{{1, {{0, 10}, {255, 10}}, {}}, {2, {{10, 20}, {10, 84}}, {}}}};
    const double lengthOfTwo = 64.0 / sidePx;
    EXPECT_NEAR(contrastScore(curves, {1}, vesselness, 0.1), 5.0 * lengthOfTwo * lengthOfTwo, 1e-6);
    EXPECT_EQ(contrastScore(curves, {1, 2}, vesselness, 0.1), 0.0);
    EXPECT_EQ(contrastScore(curves, {}, vesselness, 0.0), 0.0);
}

}   // namespace
}   // namespace angiopose::core
