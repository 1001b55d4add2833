#include "core/evaluation/statistics/proportion.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

TEST(ClusteredInterval, IsWiderWhereTreesDiffer)
{
    const std::vector<ClusterCount> alike(10, {5, 10});
    std::vector<ClusterCount> different;
    for (int tree = 0; tree < 10; ++tree) {
        different.push_back({tree % 2 == 0 ? 10 : 0, 10});
    }
    const Interval wilson = wilsonInterval(50, 100);
    const Interval same = clusteredInterval(alike);
    EXPECT_EQ(same.low, wilson.low);
    EXPECT_EQ(same.high, wilson.high);
    const Interval wide = clusteredInterval(different);
    EXPECT_NEAR(wide.low, 0.2, 0.101);   // of ten trees, about 2 to 8 win
    EXPECT_NEAR(wide.high, 0.8, 0.101);
    EXPECT_LT(wide.low, wilson.low);
    EXPECT_GT(wide.high, wilson.high);
}

TEST(ClusteredInterval, CoversTheTrueShareOfTreesThatDiffer)
{
    // Half of all trees win in every trial; eight trees of 20 trials each.
    int covered = 0;
    int coveredByWilson = 0;
    constexpr int patterns = 256;
    for (int pattern = 0; pattern < patterns; ++pattern) {
        std::vector<ClusterCount> trees;
        int wins = 0;
        for (int tree = 0; tree < 8; ++tree) {
            const bool isWon = (pattern >> tree & 1) != 0;
            trees.push_back({isWon ? 20 : 0, 20});
            wins += isWon ? 20 : 0;
        }
        const Interval interval = clusteredInterval(trees);
        const Interval wilson = wilsonInterval(wins, 160);
        covered += interval.low <= 0.5 && 0.5 <= interval.high ? 1 : 0;
        coveredByWilson += wilson.low <= 0.5 && 0.5 <= wilson.high ? 1 : 0;
    }
    EXPECT_GT(covered, 0.9 * patterns);
    EXPECT_LT(coveredByWilson, 0.5 * patterns);
}

TEST(ClusteredInterval, TakesWhatWasNotCountedForNothing)
{
    const Interval none = clusteredInterval({{0, 0}, {0, 0}});
    EXPECT_EQ(none.low, 0.0);
    EXPECT_EQ(none.high, 1.0);
    const Interval one = clusteredInterval({{3, 10}, {0, 0}});
    EXPECT_EQ(one.low, wilsonInterval(3, 10).low);
}

}   // namespace
}   // namespace angiopose::core
