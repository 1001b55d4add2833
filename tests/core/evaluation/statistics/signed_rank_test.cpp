#include "core/evaluation/statistics/signed_rank.h"

#include "core/support/random.h"

#include <gtest/gtest.h>
#include <cmath>

using namespace angiopose;

namespace {

using core::signedRankTest;

/// Six differences of sizes 1 … 6; those in `worse` are positive.
std::vector<double> sixDifferences(const std::vector<int>& worse)
{
    std::vector<double> differences{-1, -2, -3, -4, -5, -6};
    for (const int size : worse) {
        differences[static_cast<std::size_t>(size - 1)] = size;
    }
    return differences;
}

TEST(SignedRank, GivesThePublishedProbabilitiesAndEffectSizes)
{
    struct Case {
        std::vector<int> worse;
        double rankSum, p, effectSize, twoSided;
    };
    // ALGORITHMS §4.6: of 64 sign patterns, 1, 2, 27 and 42 have a rank sum of at most 0, 1, 9 and 12.
    const std::vector<Case> cases{{{}, 0, 1.0 / 64, 0.8793, 2.0 / 64},
                                  {{1}, 1, 2.0 / 64, 0.7605, 4.0 / 64},
                                  {{4, 5}, 9, 27.0 / 64, 0.0805, 54.0 / 64},
                                  {{1, 5, 6}, 12, 42.0 / 64, -0.1642, 54.0 / 64}};
    for (const Case& expected : cases) {
        const auto test = signedRankTest(sixDifferences(expected.worse));
        EXPECT_EQ(test.count, 6);
        EXPECT_EQ(test.rankSum, expected.rankSum);
        EXPECT_DOUBLE_EQ(test.pLess, expected.p);
        EXPECT_NEAR(test.effectSize, expected.effectSize, 5e-5);
        EXPECT_DOUBLE_EQ(test.pTwoSided, expected.twoSided);
    }
}

TEST(SignedRank, EffectSizesStayWithinOne)
{
    for (const int count : {6, 45, 50, 51, 10000}) {
        const std::vector<double> better(static_cast<std::size_t>(count), -1.0);
        const std::vector<double> worse(static_cast<std::size_t>(count), 1.0);
        EXPECT_LE(signedRankTest(better).effectSize, 1.0) << count;
        EXPECT_GT(signedRankTest(better).effectSize, 0.8) << count;   // regardless of how small p is
        EXPECT_GE(signedRankTest(worse).effectSize, -1.0) << count;
        EXPECT_LT(signedRankTest(worse).effectSize, -0.8) << count;
    }
}

TEST(SignedRank, DropsZerosAndSharesRanksOfEqualSizes)
{
    const auto test = signedRankTest({0.0, -1.0, 1.0, -2.0, 0.0});
    EXPECT_EQ(test.count, 3);
    EXPECT_DOUBLE_EQ(test.rankSum, 1.5);
    // Ranks 1.5, 1.5, 3: of 8 patterns, those with sums of 0 and 1.5 (twice).
    EXPECT_DOUBLE_EQ(test.pLess, 3.0 / 8.0);
    const auto none = signedRankTest({0.0, 0.0});
    EXPECT_EQ(none.count, 0);
    EXPECT_EQ(none.pLess, 1.0);
}

TEST(SignedRank, NormalApproximationContinuesTheExactOne)
{
    core::CounterRandom random(5);
    std::vector<double> differences;
    for (int k = 0; k < 50; ++k) {
        differences.push_back(random.normal() - 0.3);
    }
    const auto exact = signedRankTest(differences);
    differences.push_back(1e-9);   // one more difference, with the smallest rank
    const auto normal = signedRankTest(differences);
    EXPECT_NEAR(normal.pLess, exact.pLess, 0.15 * exact.pLess);
}

TEST(SignedRank, IsCalibratedWhenNeitherSideIsBetter)
{
    core::CounterRandom random(6);
    int rejected = 0;
    for (int repeat = 0; repeat < 2000; ++repeat) {
        std::vector<double> differences;
        for (int k = 0; k < 12; ++k) {
            differences.push_back(random.normal());
        }
        rejected += signedRankTest(differences).pLess <= 0.05 ? 1 : 0;
    }
    EXPECT_NEAR(rejected / 2000.0, 0.046, 0.015);   // 189 of the 4096 patterns lie at or below 5 %
}

TEST(HodgesLehmann, IsTheMedianOfAllPairMeans)
{
    EXPECT_DOUBLE_EQ(core::hodgesLehmann({1.0, 2.0, 9.0}), 3.5);   // 1, 1.5, 2, 5, 5.5, 9
    EXPECT_DOUBLE_EQ(core::hodgesLehmann({-4.0}), -4.0);
    EXPECT_TRUE(std::isnan(core::hodgesLehmann({})));
}

TEST(NormalQuantile, InvertsTheDistribution)
{
    EXPECT_NEAR(core::normalQuantile(0.975), 1.959963984540054, 1e-12);
    EXPECT_NEAR(core::normalQuantile(0.5), 0.0, 1e-12);
    EXPECT_NEAR(core::normalQuantile(1.0 / 64.0), -2.153874694061456, 1e-9);
}

}   // namespace
