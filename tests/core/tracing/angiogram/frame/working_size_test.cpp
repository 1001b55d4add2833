#include "core/tracing/angiogram/frame/working_size.h"

#include "core/tracing/angiogram/trace_angiogram.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using core::ImageF;

TEST(WorkingSize, UsualFramesAreTakenAsTheyAre)
{
    EXPECT_EQ(core::chooseWorkingSize(ImageF(512, 512)).halvings, 0);
    EXPECT_EQ(core::chooseWorkingSize(ImageF(300, 300)).halvings, 0);
    EXPECT_EQ(core::chooseWorkingSize(ImageF(1024, 1024)).halvings, 1);
    EXPECT_EQ(core::chooseWorkingSize(ImageF(2048, 1600)).halvings, 2);
    EXPECT_EQ(core::chooseWorkingSize(ImageF(150, 200)).halvings, -1);
    EXPECT_EQ(core::chooseWorkingSize(ImageF(20, 20)).halvings, -2);
}

TEST(WorkingSize, PixelCentersStayWhereTheyWere)
{
    // Pixel (1, 0) of a halved frame covers columns 2 and 3.
    const auto back = core::fromWorkingSize({Eigen::Vector2d(1.0, 0.0)}, core::WorkingSize{1});
    EXPECT_EQ(back.front(), Eigen::Vector2d(2.5, 0.5));
    const auto same = core::fromWorkingSize({Eigen::Vector2d(2.5, 0.5)}, core::WorkingSize{-1});
    EXPECT_EQ(same.front(), Eigen::Vector2d(1.0, 0.0));
}

/// A vessel across a frame of the given side length, with a width that is a fixed share of it.
class FrameOfSide : public testing::TestWithParam<int> {};

TEST_P(FrameOfSide, GivesTheSameVessel)
{
    const double side = GetParam();
    const test::Path path = test::line({0.1 * side, 0.2 * side}, {0.9 * side, 0.7 * side});
    const ImageF frame =
        test::drawnFrame(GetParam(), GetParam(), {path}, 0.012 * side, {.blurPx = 0.002 * side, .noise = 3.0});
    const auto trace = core::traceAngiogram(frame, core::Polarity::VesselsDark);
    ASSERT_TRUE(trace) << trace.error().message;
    ASSERT_EQ(trace.value().centerline.curves.size(), 1U);
    const core::Curve2d& curve = trace.value().centerline.curves.front();
    EXPECT_NEAR(curve.lengthPx() / side, 0.943, 0.04);
    double sum = 0.0;
    for (const Eigen::Vector2d& point : curve.pointsPx) {
        sum += test::distanceTo(path, point);
    }
    EXPECT_LT(sum / static_cast<double>(curve.pointsPx.size()), 0.2 * std::max(1.0, side / 512.0));
    EXPECT_EQ(trace.value().vesselMask.width, frame.width);
    EXPECT_EQ(trace.value().fieldMask.height, frame.height);
    EXPECT_EQ(trace.value().vesselness.pixels.size(), frame.pixels.size());
}

INSTANTIATE_TEST_SUITE_P(AllSizes, FrameOfSide, testing::Values(150, 301, 512, 901, 1024));

}   // namespace
