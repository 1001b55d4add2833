#include "core/tracing/angiogram/trace_angiogram.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using test::Path;

/// Share of the path, sampled in steps of 1 px, that has a curve within 1.5 px.
double foundShare(const core::Centerline2d& centerline, const Path& path)
{
    const Eigen::Vector2d way = path.back() - path.front();
    const int steps = static_cast<int>(way.norm());
    int found = 0;
    for (int k = 0; k <= steps; ++k) {
        const Eigen::Vector2d point = path.front() + way * k / steps;
        found += std::ranges::any_of(core::resampled(centerline, 0.5).curves, [&](const core::Curve2d& curve) {
            return std::ranges::any_of(curve.pointsPx, [&](const auto& p) { return (p - point).norm() <= 1.5; });
        });
    }
    return static_cast<double>(found) / (steps + 1);
}

class NeighborsApart : public testing::TestWithParam<double> {};

TEST_P(NeighborsApart, AreTwoCurvesAndNoneBetween)
{
    const Eigen::Vector2d apart(0.0, GetParam());
    const Path upper = test::line({20.0, 70.0}, {180.0, 100.0});
    const Path lower = {upper.front() + apart, upper.back() + apart};
    const auto frame = test::drawnFrame(200, 200, {upper, lower}, 2.5, {.noise = 5.0});
    const auto trace = core::traceAngiogram(frame, core::Polarity::VesselsDark);
    ASSERT_TRUE(trace) << trace.error().message;
    EXPECT_GT(foundShare(trace.value().centerline, upper), 0.9);
    EXPECT_GT(foundShare(trace.value().centerline, lower), 0.9);
    const Path between = {upper.front() + 0.5 * apart, upper.back() + 0.5 * apart};
    EXPECT_LT(foundShare(trace.value().centerline, between), 0.3);
}

INSTANTIATE_TEST_SUITE_P(Distances, NeighborsApart, testing::Values(8.0, 9.0, 10.0, 12.0, 16.0));

}   // namespace
