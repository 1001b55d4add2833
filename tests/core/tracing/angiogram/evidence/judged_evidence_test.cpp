#include "core/tracing/angiogram/evidence/judged_evidence.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using core::ImageF;
using core::Mask2d;

TEST(GreyOutside, IsTheMiddleOfTheField)
{
    ImageF frame(5, 1);
    frame.pixels = {0.0F, 10.0F, 20.0F, 90.0F, 0.0F};
    Mask2d field(5, 1, 255);
    field.pixels.front() = 0;
    field.pixels.back() = 0;
    EXPECT_EQ(core::withGreyOutside(frame, field).pixels, (std::vector<float>{20.0F, 10.0F, 20.0F, 90.0F, 20.0F}));
}

TEST(JudgedEvidence, FollowsTheNetwork)
{
    ImageF probability(3, 1);
    probability.pixels = {0.02F, 0.5F, 0.98F};
    const ImageF judged = core::judgedEvidence(ImageF(3, 1, 1.0F), probability, Mask2d(3, 1, 255));
    EXPECT_LT(judged.pixels[0], judged.pixels[1]);
    EXPECT_LT(judged.pixels[1], judged.pixels[2]);
    EXPECT_GT(judged.pixels[2], 1.0F);
}

TEST(JudgedEvidence, StaysNothingOutsideTheField)
{
    const ImageF judged = core::judgedEvidence(ImageF(2, 2), ImageF(2, 2, 1.0F), Mask2d(2, 2, 0));
    EXPECT_EQ(judged.pixels, ImageF(2, 2).pixels);
    EXPECT_EQ(core::likelyVessels(ImageF(2, 2, 1.0F), Mask2d(2, 2, 0)).pixels, Mask2d(2, 2).pixels);
}

TEST(DeviceCurves, AreThoseThatMostlyRunAlongDevices)
{
    core::FrameClasses classes{ImageF(20, 20, 0.2F), ImageF(20, 20, 0.1F)};
    for (int x = 0; x < 20; ++x) {
        classes.device.at(x, 10) = 0.7F;
    }
    core::Centerline2d curves;
    curves.curves.resize(2);
    curves.curves[0].id = 1;
    curves.curves[1].id = 2;
    for (int x = 0; x < 20; ++x) {
        curves.curves[0].pointsPx.emplace_back(2.0 * x + 0.5, 20.5);   // of a frame twice as large
        curves.curves[1].pointsPx.emplace_back(2.0 * x + 0.5, 4.5);
    }
    EXPECT_EQ(core::deviceCurves(curves, classes, 0.5), std::vector<int>{1});
}

}   // namespace
