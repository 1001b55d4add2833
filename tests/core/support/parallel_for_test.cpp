#include "core/support/parallel_for.h"

#include <gtest/gtest.h>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

using namespace angiopose;

namespace {

using namespace core;

TEST(ParallelFor, WorkOfAHelperThatThrowsReachesTheCaller)
{
    std::atomic<int> done{0};
    const auto work = [&](std::size_t i) {
        if (i == 3) {
            throw std::runtime_error("piece 3");
        }
        ++done;
    };
    for (const int threads : {1, 4}) {
        EXPECT_THROW(parallelFor(1000, threads, work, [](double) { return true; }), std::runtime_error);
    }
    EXPECT_LT(done, 2000);
}

TEST(ParallelFor, StopLeavesTheRestUndone)
{
    const auto work = [](std::size_t) { std::this_thread::sleep_for(std::chrono::microseconds(200)); };
    EXPECT_FALSE(parallelFor(1000, 2, work, [](double) { return false; }));   // long before the other thread finishes
    EXPECT_TRUE(parallelFor(
        10, 2, [](std::size_t) {}, [](double) { return true; }));
}

TEST(AtOnce, WhatEitherPieceThrowsReachesTheCallerAfterBothHaveEnded)
{
    bool isOtherDone = false;
    const auto fails = [] { throw std::runtime_error("no"); };
    const auto works = [&] { isOtherDone = true; };
    EXPECT_THROW(runInParallel(works, fails), std::runtime_error);
    EXPECT_TRUE(isOtherDone);
    isOtherDone = false;
    EXPECT_THROW(runInParallel(fails, works), std::runtime_error);
    EXPECT_TRUE(isOtherDone || std::thread::hardware_concurrency() == 1);
}

}   // namespace
