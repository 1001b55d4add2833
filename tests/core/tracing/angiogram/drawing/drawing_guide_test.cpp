#include "core/tracing/angiogram/drawing/drawing_guide.h"

#include "core/tracing/angiogram/drawing/edit_centerline.h"
#include "core/tracing/angiogram/drawing/live_wire.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using core::Polarity;

const test::Path deformation{{20.0, 30.0}, {90.0, 40.0}, {150.0, 110.0}};

TEST(DrawingGuide, LeadsAWireAlongAFaintVessel)
{
    core::ImageF frame = test::drawnFrame(180, 140, {deformation}, 3.0, {.background = 900.0F, .depth = 60.0F});
    test::addNoise(frame, 10.0, 5);
    const core::DrawingGuide ground = core::computeDrawingGuide(frame, Polarity::VesselsDark);
    core::LiveWire wire(ground.vesselness);
    wire.setAnchor({22.0, 33.0});
    const auto drawn = core::addDrawnCurve({}, wire.pathTo({147.0, 105.0}), ground.opacity);
    ASSERT_EQ(drawn.curves.size(), 1U);
    for (const Eigen::Vector2d& point : drawn.curves.front().pointsPx) {
        EXPECT_LT(test::distanceTo(deformation, point), 1.5);
    }
}

TEST(DrawingGuide, BrightVesselsAreTheSame)
{
    const core::ImageF frame = test::drawnFrame(180, 140, {deformation}, 3.0, {.background = 900.0F, .depth = 200.0F});
    core::ImageF negative = frame;
    for (float& value : negative.pixels) {
        value = 2000.0F - value;
    }
    const auto dark = core::computeDrawingGuide(frame, Polarity::VesselsDark);
    const auto bright = core::computeDrawingGuide(negative, Polarity::VesselsBright);
    EXPECT_NEAR(dark.vesselness.at(55, 35), bright.vesselness.at(55, 35), 0.05);
    EXPECT_GT(dark.vesselness.at(55, 35), 0.4F);
    EXPECT_LT(dark.vesselness.at(55, 90), 0.1F);
}

TEST(DrawingGuide, AFrameWithoutVesselsStillHasOne)
{
    const core::DrawingGuide ground = core::computeDrawingGuide(core::ImageF(64, 48, 100.0F), Polarity::VesselsDark);
    EXPECT_EQ(ground.vesselness.width, 64);
    EXPECT_TRUE(core::computeDrawingGuide({}, Polarity::VesselsDark).vesselness.isEmpty());
}

}   // namespace
