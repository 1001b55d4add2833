#include "core/tracing/angiogram/curves/straight_crossings.h"

#include "core/tracing/angiogram/trace_angiogram.h"
#include "tests/support/drawn_vessels.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>
#include <cmath>

using namespace angiopose;

namespace {

using core::Mask2d;

const Mask2d wholeImage(256, 200, 255);

TEST(LinesAcross, RunStraightFromRimToRim)
{
    EXPECT_TRUE(core::crossesFieldStraight(test::line({3, 20}, {252, 150}), wholeImage));
    EXPECT_TRUE(core::crossesFieldStraight(test::line({90, 4}, {110, 196}), wholeImage));
}

TEST(LinesAcross, VesselsEndInsideOrDeformation)
{
    EXPECT_FALSE(core::crossesFieldStraight(test::line({3, 20}, {200, 150}), wholeImage));   // ends inside the image
    test::Path deformed;
    for (double x = 3.0; x <= 252.0; x += 1.0) {
        deformed.emplace_back(x, 80.0 + 0.3 * x + 12.0 * std::sin(x / 40.0));
    }
    EXPECT_FALSE(core::crossesFieldStraight(deformed, wholeImage));
    EXPECT_FALSE(core::crossesFieldStraight(test::line({3, 40}, {40, 3}), wholeImage));   // cuts off a corner
    EXPECT_FALSE(core::crossesFieldStraight({}, wholeImage));
    EXPECT_FALSE(core::crossesFieldStraight({{3.0, 3.0}}, wholeImage));
}

TEST(LinesAcross, TheShuttersAreTheRim)
{
    Mask2d field(256, 200);
    test::forEachPixel({60, 50}, {200, 150}, [&](int x, int y) { field.at(x, y) = 255; });
    EXPECT_TRUE(core::crossesFieldStraight(test::line({63, 100}, {196, 120}), field));
    EXPECT_FALSE(core::crossesFieldStraight(test::line({63, 100}, {130, 120}), field));
}

TEST(LinesAcross, AreNotTraced)
{
    const test::Path lead = test::line({100, 0}, {140, 255});
    const test::Path vessel = test::circle({110, 120}, 70);
    const auto trace = core::traceAngiogram(test::drawnFrame(256, 256, {lead, vessel}, 3.0, {.noise = 3.0}),
                                            core::Polarity::VesselsDark);
    ASSERT_TRUE(trace);
    double offVesselPx = 0.0;
    for (const core::Curve2d& curve : trace.value().centerline.curves) {
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            offVesselPx += test::distanceTo(vessel, point) > 5.0 ? 1.0 : 0.0;
        }
    }
    EXPECT_LT(offVesselPx, 10.0);
}

}   // namespace
