#include "core/registration/run_periods.h"

#include "core/support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace angiopose::core {
namespace {

struct Waves {
    double breathMm = 0.0;
    double heartMm = 0.0;
    double noiseMm = 0.2;
    double driftMmPerS = 0.0;
};

constexpr double breathS = 3.7;
constexpr double heartS = 0.85;

std::vector<TimedPose> run(double seconds, double framesPerSecond, const Waves& waves, std::uint64_t seed = 1)
{
    CounterRandom random(seed);
    std::vector<TimedPose> poses;
    for (int k = 0; k < static_cast<int>(seconds * framesPerSecond); ++k) {
        const double t = k / framesPerSecond;
        const double up = waves.breathMm * std::sin(2.0 * std::numbers::pi * t / breathS) + waves.driftMmPerS * t;
        const double beat = waves.heartMm * std::sin(2.0 * std::numbers::pi * t / heartS + 1.0);
        TimedPose pose;
        pose.seconds = t;
        pose.cameraFromPatient.translation = {0.5 * beat + waves.noiseMm * random.normal(),
                                              up + 0.8 * beat + waves.noiseMm * random.normal(), 700.0};
        poses.push_back(pose);
    }
    return poses;
}

TEST(RunPeriods, FindsBreathAndHeart)
{
    const RunPeriods found = findPeriods(run(12.0, 15.0, {5.0, 1.5, 0.2, 0.3}), {0.0, 0.0, 0.0});
    ASSERT_TRUE(found.breathMotion);
    ASSERT_TRUE(found.heartMotion);
    EXPECT_NEAR(found.breathMotion->periodS, breathS, 0.2);
    EXPECT_NEAR(found.breathMotion->amplitudeMm, 5.0, 0.5);
    EXPECT_NEAR(found.heartMotion->periodS, heartS, 0.03);
    EXPECT_NEAR(found.heartMotion->amplitudeMm, 1.5 * std::hypot(0.5, 0.8), 0.2);
}

TEST(RunPeriods, FindsThemWhereFramesAreMissing)
{
    std::vector<TimedPose> poses = run(12.0, 15.0, {5.0, 0.0, 0.2, 0.0});
    std::erase_if(poses, [](const TimedPose& pose) { return pose.seconds > 4.0 && pose.seconds < 6.0; });
    const RunPeriods found = findPeriods(poses, {0.0, 0.0, 0.0});
    ASSERT_TRUE(found.breathMotion);
    EXPECT_NEAR(found.breathMotion->periodS, breathS, 0.2);
}

TEST(RunPeriods, FindsNoneInNoise)
{
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const RunPeriods periods = findPeriods(run(10.0, 10.0, {0.0, 0.0, 1.0, 0.5}, seed), {0.0, 0.0, 0.0});
        found += periods.breathMotion || periods.heartMotion ? 1 : 0;
    }
    EXPECT_LE(found, 2);
}

TEST(RunPeriods, SaysNothingOfARunTooShort)
{
    const RunPeriods found = findPeriods(run(4.0, 15.0, {5.0, 0.0, 0.2, 0.0}), {0.0, 0.0, 0.0});
    EXPECT_FALSE(found.breathMotion) << "one breath and a little is no period";
    EXPECT_FALSE(findPeriods({}, {0.0, 0.0, 0.0}).breathMotion);
}

}   // namespace
}   // namespace angiopose::core
