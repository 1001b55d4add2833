#include "core/viewing/cine_clock.h"

#include <gtest/gtest.h>
#include <vector>

namespace angiopose::core {
namespace {

std::vector<int> framesOf(const CineClock& clock, int steps, double frameMs)
{
    std::vector<int> frames;
    for (int i = 0; i < steps; ++i) {
        frames.push_back(clock.frameAt((i + 0.5) * frameMs));
    }
    return frames;
}

TEST(CineClock, LoopsThroughItsRange)
{
    CineClock clock({2, 4}, CineOrder::Loop, 40.0);
    clock.start(3, 0.0);
    EXPECT_EQ(framesOf(clock, 6, 40.0), (std::vector<int>{3, 4, 2, 3, 4, 2}));
}

TEST(CineClock, TurnsAtBothEndsWithoutShowingThemTwice)
{
    CineClock clock({2, 4}, CineOrder::BackAndForth, 40.0);
    clock.start(2, 0.0);
    EXPECT_EQ(framesOf(clock, 9, 40.0), (std::vector<int>{2, 3, 4, 3, 2, 3, 4, 3, 2}));
}

TEST(CineClock, LeavesFramesOutRatherThanBeingLate)
{
    CineClock clock({0, 9}, CineOrder::Loop, 50.0);
    clock.start(0, 1000.0);
    EXPECT_EQ(clock.frameAt(1049.0), 0);
    EXPECT_EQ(clock.frameAt(1374.0), 7);   // after 325 ms without a request
    EXPECT_NEAR(clock.msUntilNextFrame(1374.0), 26.0, 1e-9);
}

TEST(CineClock, BeginsAtItsFirstFrameFromOutside)
{
    CineClock clock({5, 7}, CineOrder::Loop, 50.0);
    clock.start(1, 0.0);
    EXPECT_EQ(clock.frameAt(0.0), 5);
}

TEST(CineClock, OneFrameStays)
{
    for (const CineOrder order : {CineOrder::Loop, CineOrder::BackAndForth}) {
        CineClock clock({3, 3}, order, 50.0);
        clock.start(3, 0.0);
        EXPECT_EQ(clock.frameAt(12345.0), 3);
    }
}

TEST(CineClock, TheNextFrameIsAlwaysAhead)
{
    CineClock clock({0, 9}, CineOrder::Loop, 1000.0 / 15.0);
    clock.start(0, 0.1);
    double now = 0.1;
    for (int i = 0; i < 1000; ++i) {
        const double wait = clock.msUntilNextFrame(now);
        ASSERT_GT(wait, 0.0);
        now += wait;
    }
    EXPECT_GT(now, 400 * 1000.0 / 15.0) << "rounding costs a short wait more, no standstill";
}

}   // namespace
}   // namespace angiopose::core
