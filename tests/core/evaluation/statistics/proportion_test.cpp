#include "core/evaluation/statistics/proportion.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

TEST(WilsonInterval, GivesKnownAnswers)
{
    const core::Interval none = core::wilsonInterval(0, 20);
    EXPECT_EQ(none.low, 0.0);
    EXPECT_NEAR(none.high, 0.16113, 1e-5);
    const core::Interval some = core::wilsonInterval(81, 263);   // Newcombe 1998, example of method 3
    EXPECT_NEAR(some.low, 0.2553, 5e-5);
    EXPECT_NEAR(some.high, 0.3662, 5e-5);
    const core::Interval all = core::wilsonInterval(20, 20);
    EXPECT_NEAR(all.low, 1.0 - none.high, 1e-12);
    EXPECT_EQ(all.high, 1.0);
    EXPECT_EQ(core::wilsonInterval(0, 0).high, 1.0);
}

TEST(HolmAdjusted, StepsDownAndNeverFalls)
{
    const std::vector<double> adjusted = core::adjustByHolm({0.01, 0.04, 0.03, 0.005});
    EXPECT_DOUBLE_EQ(adjusted[3], 0.02);
    EXPECT_DOUBLE_EQ(adjusted[0], 0.03);
    EXPECT_DOUBLE_EQ(adjusted[2], 0.06);
    EXPECT_DOUBLE_EQ(adjusted[1], 0.06);
    // The three comparisons of the paper, each at the smallest p that six pairs allow (ALGORITHMS §4.6).
    for (const double p : core::adjustByHolm({1.0 / 64, 1.0 / 64, 1.0 / 64})) {
        EXPECT_NEAR(p, 0.047, 5e-4);
    }
    EXPECT_TRUE(core::adjustByHolm({}).empty());
}

}   // namespace
