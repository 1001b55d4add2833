#include "core/registration/alignment/residual_noise.h"

#include "core/support/random.h"

#include <gtest/gtest.h>
#include <cmath>

namespace angiopose::core {
namespace {

/// Rows of straight branches: residual = offset(branch) + AR(1) noise of 0.3 px, with correlation `kept` between
/// neighbors.
template <class Offset>
std::vector<ResidualRow> rowsWith(double kept, Offset offset)
{
    constexpr int branches = 40;
    constexpr int points = 90;
    constexpr double noisePx = 0.3;
    CounterRandom random(3);
    std::vector<ResidualRow> rows;
    for (int branch = 0; branch < branches; ++branch) {
        double noise = noisePx * random.normal();
        for (int i = 0; i < points; ++i) {
            ResidualRow row;
            row.branchIndex = branch;
            row.weight = 1.0;
            row.residual = offset(branch) + noise;
            rows.push_back(row);
            noise = kept * noise + noisePx * std::sqrt(1.0 - kept * kept) * random.normal();
        }
    }
    return rows;
}

double none(int)
{
    return 0.0;
}

TEST(ResidualNoise, OfWhiteNoiseIsItsStandardDeviation)
{
    const ResidualNoise noise = residualNoise(rowsWith(0.0, none));
    EXPECT_NEAR(noise.scatterPx, 0.3, 0.02);
    EXPECT_NEAR(noise.correlationPoints, 1.0, 0.2);
    EXPECT_FALSE(noise.hasOffsets());
}

TEST(ResidualNoise, KnowsHowFarNeighborsSayTheSame)
{
    const double kept = std::exp(-1.0 / 5.0);
    const ResidualNoise noise = residualNoise(rowsWith(kept, none));
    const double truth = 0.09 * (1.0 + kept) / (1.0 - kept);
    EXPECT_NEAR(noise.rowVariance() / ResidualNoise::nearestPointBias, truth, 0.3 * truth);
    EXPECT_LT(noise.offsetPx, 0.15);
}

TEST(ResidualNoise, NoticesBranchesThatAreOff)
{
    const ResidualNoise noise = residualNoise(rowsWith(0.0, [](int branch) { return branch % 2 == 0 ? 0.6 : -0.6; }));
    EXPECT_TRUE(noise.hasOffsets());
    EXPECT_NEAR(noise.scatterPx, 0.3, 0.03);
    EXPECT_NEAR(noise.offsetPx, 0.6 * 1.4826,
                0.05);   // a robust estimate takes two values for the quartiles of a Gaussian
}

TEST(ResidualNoise, OfHardlyAnyMatchesIsLarge)
{
    const auto rows = rowsWith(0.0, none);
    EXPECT_GT(residualNoise({rows.begin(), rows.begin() + 20}).scatterPx, 3.0);
}

}   // namespace
}   // namespace angiopose::core
