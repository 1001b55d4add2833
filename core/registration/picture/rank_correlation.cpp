#include "core/registration/picture/rank_correlation.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace angiopose::core {
namespace {

constexpr std::size_t grayBins = 256;

/// Returns the tie-averaged ranks minus their mean.
std::vector<double> centeredRanks(const std::vector<float>& values)
{
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double scale = *high > *low ? (grayBins - 1) / static_cast<double>(*high - *low) : 0.0;
    std::vector<std::size_t> bin(values.size());
    std::array<double, grayBins> count{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        bin[i] = static_cast<std::size_t>(scale * static_cast<double>(values[i] - *low));
        count[bin[i]] += 1.0;
    }
    std::array<double, grayBins> meanRank{};
    double below = 0.0;
    for (std::size_t b = 0; b < grayBins; ++b) {
        meanRank[b] = below + 0.5 * count[b] - 0.5 * static_cast<double>(values.size());
        below += count[b];
    }
    std::vector<double> ranks(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        ranks[i] = meanRank[bin[i]];
    }
    return ranks;
}

}   // namespace

double rankCorrelation(const std::vector<float>& a, const std::vector<float>& b)
{
    assert(a.size() == b.size());
    if (a.empty()) {
        return 0.0;
    }
    const std::vector<double> ranksA = centeredRanks(a);
    const std::vector<double> ranksB = centeredRanks(b);
    double ab = 0.0;
    double aa = 0.0;
    double bb = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += ranksA[i] * ranksB[i];
        aa += ranksA[i] * ranksA[i];
        bb += ranksB[i] * ranksB[i];
    }
    return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

}   // namespace angiopose::core
