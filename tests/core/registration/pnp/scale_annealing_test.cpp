#include "core/registration/pnp/scale_annealing.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

TEST(ScaleAnnealing, HalvesEveryFiveStepsDownToItsFloor)
{
    ScaleAnnealing annealing(Decay::Halving, 3.0, 1.0);
    for (const double expected : {3.0, 1.5, 1.0, 1.0}) {
        EXPECT_DOUBLE_EQ(annealing.scalePx(), expected);
        for (int step = 0; step < 5; ++step) {
            annealing.countStep(100);
        }
    }
    EXPECT_TRUE(annealing.isFinal());
}

TEST(ScaleAnnealing, StagnationWaitsWhilePointsStillComeWithinReach)
{
    ScaleAnnealing annealing(Decay::Stagnation, 10.0, 1.0);
    for (int step = 0; step < 25; ++step) {
        annealing.countStep(100 + step);
    }
    EXPECT_DOUBLE_EQ(annealing.scalePx(), 10.0);
    annealing.countStep(100);
    EXPECT_DOUBLE_EQ(annealing.scalePx(), 7.0);
}

TEST(ScaleAnnealing, StagnationSpendsAtLeastTenStepsAtOneScale)
{
    ScaleAnnealing annealing(Decay::Stagnation, 10.0, 1.0);
    for (int step = 0; step < 9; ++step) {
        annealing.countStep(100);
        EXPECT_DOUBLE_EQ(annealing.scalePx(), 10.0);
    }
    annealing.countStep(100);
    EXPECT_DOUBLE_EQ(annealing.scalePx(), 7.0);
}

TEST(ScaleAnnealing, StartsAtItsFloorWhenTheStartIsFiner)
{
    ScaleAnnealing annealing(Decay::Halving, 0.2, 1.0);
    EXPECT_DOUBLE_EQ(annealing.scalePx(), 1.0);
    EXPECT_FALSE(annealing.shrinkScale());
}

}   // namespace
