#include "core/tracing/angiogram/evidence/vessel_network.h"

#include "core/tracing/angiogram/trace_angiogram.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>
#include <array>
#include <thread>

using namespace angiopose;

namespace {

using core::FrameClasses;
using core::ImageF;
using core::Polarity;

const test::Path vesselCourse = test::line({40, 60}, {250, 210});

ImageF frameWithVessel()
{
    return test::drawnFrame(300, 270, {vesselCourse}, 3.5, {.noise = 4.0});
}

/// Skips where the program was built without weights.
class TrainedNetwork : public testing::Test {
protected:
    void SetUp() override
    {
        if (core::trainedNetwork() == nullptr) {
            GTEST_SKIP() << "built without weights";
        }
    }

    static FrameClasses seen(const ImageF& frame) { return core::trainedNetwork()->classesOf(frame); }
};

double meanOver(const ImageF& image, double nearest, double farthest)
{
    double sum = 0.0;
    int count = 0;
    for (int y = 10; y + 10 < image.height; ++y) {
        for (int x = 10; x + 10 < image.width; ++x) {
            const double distance = test::distanceTo(vesselCourse, {x, y});
            if (distance >= nearest && distance <= farthest) {
                sum += image.at(x, y);
                ++count;
            }
        }
    }
    return sum / count;
}

TEST_F(TrainedNetwork, GivesProbabilitiesOfTheFramesSize)
{
    const FrameClasses classes = seen(frameWithVessel());
    ASSERT_EQ(classes.vessel.width, 300);
    ASSERT_EQ(classes.device.height, 270);
    for (std::size_t i = 0; i < classes.vessel.pixels.size(); ++i) {
        ASSERT_GE(classes.vessel.pixels[i], 0.0F);
        ASSERT_GE(classes.device.pixels[i], 0.0F);
        ASSERT_LE(classes.vessel.pixels[i] + classes.device.pixels[i], 1.0F + 1e-5F);
    }
}

TEST_F(TrainedNetwork, SeesADrawnVesselAndLittleElse)
{
    const FrameClasses classes = seen(frameWithVessel());
    EXPECT_GT(meanOver(classes.vessel, 0.0, 1.5), 0.6);
    EXPECT_LT(meanOver(classes.vessel, 12.0, 1000.0), 0.05);
}

TEST_F(TrainedNetwork, SeesTheSameWhateverBrightnessAndContrast)
{
    const ImageF frame = frameWithVessel();
    ImageF other = frame;
    for (float& value : other.pixels) {
        value = 1000.0F + 7.0F * value;
    }
    const FrameClasses before = seen(frame);
    const FrameClasses after = seen(other);
    for (std::size_t i = 0; i < before.vessel.pixels.size(); ++i) {
        ASSERT_NEAR(before.vessel.pixels[i], after.vessel.pixels[i], 0.02F);
    }
}

TEST_F(TrainedNetwork, GivesTheSameBitsAgainAndOnSeveralThreads)
{
    const ImageF frame = frameWithVessel();
    const FrameClasses first = seen(frame);
    std::array<FrameClasses, 4> others;
    {
        std::array<std::jthread, 4> threads;
        for (std::size_t t = 0; t < threads.size(); ++t) {
            threads[t] = std::jthread([&, t] { others[t] = seen(frame); });
        }
    }
    for (const FrameClasses& other : others) {
        EXPECT_EQ(other.vessel.pixels, first.vessel.pixels);
        EXPECT_EQ(other.device.pixels, first.device.pixels);
    }
}

TEST_F(TrainedNetwork, ReadsFramesOfAnySize)
{
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 700}, {1024, 1000}, {17, 16}}) {
        const FrameClasses classes = seen(ImageF(width, height, 5.0F));
        EXPECT_EQ(classes.vessel.width, width);
        EXPECT_EQ(classes.vessel.height, height);
    }
}

TEST_F(TrainedNetwork, IsAskedOnlyWhereTheOptionsSaySo)
{
    const ImageF frame = frameWithVessel();
    const auto alone = core::traceAngiogram(frame, Polarity::VesselsDark);
    const auto without = core::traceAngiogram(frame, Polarity::VesselsDark, {}, nullptr);
    const auto with = core::traceAngiogram(frame, Polarity::VesselsDark, {.usesNetwork = true});
    ASSERT_TRUE(alone && without && with);
    ASSERT_EQ(alone.value().centerline.curves.size(), without.value().centerline.curves.size());
    EXPECT_EQ(alone.value().centerline.curves[0].pointsPx, without.value().centerline.curves[0].pointsPx);
    EXPECT_EQ(alone.value().vesselMask.pixels, without.value().vesselMask.pixels);
    EXPECT_NE(alone.value().vesselMask.pixels, with.value().vesselMask.pixels);
}

TEST(VesselNetwork, IsNotReadFromOtherBytes)
{
    EXPECT_FALSE(core::VesselNetwork::read({}));
    EXPECT_FALSE(core::VesselNetwork::read(std::array<std::uint8_t, 5>{1, 2, 3, 4, 5}));
}

}   // namespace
