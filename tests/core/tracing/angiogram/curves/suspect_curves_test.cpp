#include "core/tracing/angiogram/curves/suspect_curves.h"

#include <gtest/gtest.h>
#include <cmath>

using namespace angiopose;

namespace {

using core::Centerline2d;
using core::Curve2d;

constexpr int frameSidePx = 512;

/// A curve of 200 px along x, with the given lateral offset and width at each x.
template <class Course, class Width>
Curve2d drawnCurve(int id, Course course, Width width)
{
    Curve2d curve{id, {}, {}};
    for (int x = 0; x <= 200; ++x) {
        curve.pointsPx.emplace_back(100.0 + x, 200.0 + course(x));
        curve.radiusPx.push_back(width(x));
    }
    return curve;
}

const auto straightCourse = [](double) { return 0.0; };
const auto arc = [](double x) { return std::sqrt(400.0 * 400.0 - (x - 80.0) * (x - 80.0)) - 400.0; };
const auto windingCurve = [](double x) { return 6.0 * std::sin(0.06 * x); };
const auto even = [](double) { return 2.0; };
const auto tapering = [](double x) { return 3.0 - 0.009 * x; };

TEST(SuspectCurves, AreStraightOrEvenlyDeformedAndOfEvenWidth)
{
    const Centerline2d centerline{{drawnCurve(1, straightCourse, even), drawnCurve(2, arc, even)}};
    EXPECT_EQ(core::suspectCurves(centerline, frameSidePx), (std::vector<int>{1, 2}));
}

TEST(SuspectCurves, VesselsWindOrTaper)
{
    const Centerline2d centerline{{drawnCurve(1, windingCurve, even), drawnCurve(2, arc, tapering)}};
    EXPECT_TRUE(core::suspectCurves(centerline, frameSidePx).empty());
}

TEST(SuspectCurves, ShortOnesAreNotJudged)
{
    EXPECT_TRUE(core::suspectCurves({{drawnCurve(1, straightCourse, even)}}, 2048).empty());
    EXPECT_TRUE(core::suspectCurves({{Curve2d{1, {{3.0, 4.0}}, {1.0}}, Curve2d{}}}, 4).empty());
}

/// A full circle except for a gap between its ends.
Curve2d loopOf(int id, double radius, double gapRad)
{
    Curve2d curve{id, {}, {}};
    for (double angle = 0.0; angle < 6.28 - gapRad; angle += 0.02) {
        curve.pointsPx.emplace_back(200.0 + radius * std::cos(angle), 200.0 + 0.6 * radius * std::sin(angle));
        curve.radiusPx.push_back(1.5);
    }
    return curve;
}

TEST(SuspectCurves, LoopsOfWireAreClosed)
{
    EXPECT_EQ(core::suspectCurves({{loopOf(1, 16.0, 0.1), loopOf(2, 16.0, 2.5), loopOf(3, 120.0, 0.1)}}, frameSidePx),
              std::vector<int>{1});
}

TEST(SuspectCurves, WithoutWidthsTheCourseDecides)
{
    Curve2d unknown = drawnCurve(4, arc, tapering);
    unknown.radiusPx.clear();
    EXPECT_EQ(core::suspectCurves({{unknown}}, frameSidePx), std::vector<int>{4});
}

}   // namespace
