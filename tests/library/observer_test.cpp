#include "angiopose/angiopose.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace angiopose {
namespace {

const RegistrationInput& input()
{
    static const RegistrationInput made = [] {
        SimulationOptions options;
        options.branchCount = 8;
        options.frameCount = 3;
        return inputOf(simulateCase(5, options).session);
    }();
    return made;
}

/// A square tube of 10 × 10 voxels along k.
std::vector<std::uint8_t> tube(const VolumeGeometry& geometry)
{
    std::vector<std::uint8_t> mask(geometry.voxelCount());
    for (int k = 4; k < geometry.size[2] - 4; ++k) {
        for (int j = 10; j < 20; ++j) {
            for (int i = 10; i < 20; ++i) {
                mask[static_cast<std::size_t>((k * geometry.size[1] + j) * geometry.size[0] + i)] = 1;
            }
        }
    }
    return mask;
}

TEST(Observer, FollowsARegistrationWithoutEverGoingBack)
{
    double last = 0.0;
    int reports = 0;
    const auto result = registerVessels(input(), {}, [&](const Progress& progress) {
        EXPECT_GE(progress.fraction, last);
        EXPECT_LE(progress.fraction, 1.0);
        EXPECT_TRUE(progress.cameraFromPatient.has_value());
        EXPECT_FALSE(progress.stage.empty());
        last = progress.fraction;
        ++reports;
        return Verdict::Continue;
    });
    EXPECT_GT(reports, 3);
    EXPECT_NE(StopReason::StoppedByUser, result.stopReason);
}

TEST(Observer, StopKeepsTheBestPose)
{
    const auto result = registerVessels(input(), {}, [](const Progress&) { return Verdict::Stop; });
    EXPECT_EQ(StopReason::StoppedByUser, result.stopReason);
    EXPECT_GT(result.metrics.medianPx, 0.0);
}

TEST(Observer, WhatItThrowsComesOut)
{
    int reports = 0;
    EXPECT_THROW(registerVessels(input(), {},
                                 [&](const Progress&) -> Verdict {
                                     ++reports;
                                     throw std::domain_error("mine");
                                 }),
                 std::domain_error);
    EXPECT_EQ(1, reports);
}

TEST(Observer, StoppedTracingGivesNothing)
{
    VolumeGeometry geometry;
    geometry.size = {30, 30, 60};
    const auto mask = tube(geometry);
    EXPECT_THROW(traceMask(mask, geometry, {}, [](const Progress&) { return Verdict::Stop; }), Stopped);
    const TracedVessels vessels = traceMask(mask, geometry);
    EXPECT_GT(vessels.tree.points.size(), 20U);
    EXPECT_EQ(mask.size(), vessels.lumen.size());
}

}   // namespace
}   // namespace angiopose
