#include "core/evaluation/statistics/signed_rank.h"

#include "core/support/quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace angiopose::core {
namespace {

constexpr std::size_t maxExactCount = 50;

/// Returns twice the mid-ranks by absolute value; doubling keeps them integers even for ties.
std::vector<int> doubledRanks(const std::vector<double>& differences)
{
    std::vector<std::size_t> order(differences.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return std::abs(differences[a]) < std::abs(differences[b]); });
    std::vector<int> ranks(differences.size());
    for (std::size_t from = 0; from < order.size();) {
        std::size_t to = from;
        while (to < order.size() && std::abs(differences[order[to]]) == std::abs(differences[order[from]])) {
            ++to;
        }
        for (std::size_t k = from; k < to; ++k) {
            ranks[order[k]] = static_cast<int>(from + 1 + to);   // twice the mean of the ranks from + 1, …, to
        }
        from = to;
    }
    return ranks;
}

/// Returns P(sum of positive ranks ≤ s) for every s, with all sign patterns equally likely.
std::vector<double> exactDistribution(const std::vector<int>& ranks)
{
    std::vector<double> share(static_cast<std::size_t>(std::accumulate(ranks.begin(), ranks.end(), 0)) + 1, 0.0);
    share[0] = 1.0;
    for (const int rank : ranks) {
        for (std::size_t s = share.size(); s-- > 0;) {
            const double withPlus = s >= static_cast<std::size_t>(rank) ? share[s - static_cast<std::size_t>(rank)] : 0;
            share[s] = 0.5 * (share[s] + withPlus);
        }
    }
    std::partial_sum(share.begin(), share.end(), share.begin());
    return share;
}

double normalCdf(double z)
{
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

/// Tail probabilities of the doubled rank sum under the null hypothesis.
struct Tails {
    double below = 1.0;   ///< P(this sum or smaller)
    double above = 1.0;   ///< P(this sum or larger)
    double z = 0.0;   ///< standard normal quantile of `below` with the sign reversed
};

Tails exactTails(const std::vector<int>& ranks, int doubledSum)
{
    const std::vector<double> below = exactDistribution(ranks);
    const auto s = static_cast<std::size_t>(doubledSum);
    return {below[s], s == 0 ? 1.0 : 1.0 - below[s - 1], -normalQuantile(std::min(below[s], 1.0 - 1e-15))};
}

Tails normalTails(const std::vector<int>& ranks, int doubledSum)
{
    double mean = 0.0;
    double variance = 0.0;   // of the sum of independent rank × {0, 1}: the ranks already account for ties
    for (const int rank : ranks) {
        mean += 0.25 * rank;
        variance += rank * rank / 16.0;
    }
    const double sum = 0.5 * doubledSum;
    const double std = std::sqrt(variance);
    const double z = (mean - sum - 0.5) / std;   // stays finite even if its probability underflows
    return {normalCdf(-z), normalCdf((mean - sum + 0.5) / std), z};
}

}   // namespace

SignedRankTest signedRankTest(const std::vector<double>& differences)
{
    std::vector<double> values;
    std::copy_if(differences.begin(), differences.end(), std::back_inserter(values), [](double d) { return d != 0.0; });
    SignedRankTest test;
    test.count = static_cast<int>(values.size());
    if (values.empty()) {
        return test;
    }
    const std::vector<int> ranks = doubledRanks(values);
    int doubledSum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        doubledSum += values[i] > 0.0 ? ranks[i] : 0;
    }
    const Tails tails = values.size() <= maxExactCount ? exactTails(ranks, doubledSum) : normalTails(ranks, doubledSum);
    test.rankSum = 0.5 * doubledSum;
    test.pLess = tails.below;
    test.pTwoSided = std::min(1.0, 2.0 * std::min(tails.below, tails.above));
    // The quotient exceeds 1 from 42 exactly tested pairs on if all differences have the same sign.
    test.effectSize = std::clamp(tails.z / std::sqrt(static_cast<double>(test.count)), -1.0, 1.0);
    return test;
}

double normalQuantile(double p)
{
    double low = -40.0;
    double high = 40.0;
    for (int halving = 0; halving < 100; ++halving) {
        const double middle = 0.5 * (low + high);
        (normalCdf(middle) < p ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double hodgesLehmann(const std::vector<double>& differences)
{
    std::vector<double> means;
    means.reserve(differences.size() * (differences.size() + 1) / 2);
    for (std::size_t i = 0; i < differences.size(); ++i) {
        for (std::size_t k = i; k < differences.size(); ++k) {
            means.push_back(0.5 * (differences[i] + differences[k]));
        }
    }
    return quantile(std::move(means), 0.5);
}

}   // namespace angiopose::core
