#include "core/evaluation/statistics/proportion.h"

#include "core/support/quantile.h"
#include "core/support/random.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace angiopose::core {
namespace {

constexpr int bootstrapDraws = 2000;
constexpr std::uint64_t bootstrapSeed = 1;

/// Returns the success rates of bootstrap samples, each drawn from the trees with replacement.
std::vector<double> bootstrapRates(const std::vector<ClusterCount>& trees)
{
    CounterRandom random(bootstrapSeed);
    std::vector<double> shares;
    for (int draw = 0; draw < bootstrapDraws; ++draw) {
        ClusterCount sum;
        for (std::size_t k = 0; k < trees.size(); ++k) {
            const ClusterCount& tree = trees[static_cast<std::size_t>(random.index(static_cast<int>(trees.size())))];
            sum.successes += tree.successes;
            sum.count += tree.count;
        }
        shares.push_back(static_cast<double>(sum.successes) / sum.count);
    }
    return shares;
}

}   // namespace

Interval wilsonInterval(int successes, int count, double z)
{
    if (count <= 0) {
        return {};
    }
    const double n = count;
    const double share = successes / n;
    const double center = share + z * z / (2.0 * n);
    const double spread = z * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
    const double scale = 1.0 + z * z / n;
    // The limits 0 and 1 are exact; rounding must not change them.
    return {successes == 0 ? 0.0 : (center - spread) / scale, successes == count ? 1.0 : (center + spread) / scale};
}

std::vector<double> adjustByHolm(const std::vector<double>& pValues)
{
    std::vector<std::size_t> order(pValues.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return pValues[a] < pValues[b]; });
    std::vector<double> adjusted(pValues.size());
    double largest = 0.0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const double scaled = std::min(1.0, pValues[order[k]] * static_cast<double>(order.size() - k));
        largest = std::max(largest, scaled);
        adjusted[order[k]] = largest;
    }
    return adjusted;
}

Interval clusteredInterval(const std::vector<ClusterCount>& trees)
{
    std::vector<ClusterCount> counted;
    std::ranges::copy_if(trees, std::back_inserter(counted), [](const ClusterCount& tree) { return tree.count > 0; });
    ClusterCount all;
    for (const ClusterCount& tree : counted) {
        all.successes += tree.successes;
        all.count += tree.count;
    }
    const Interval wilson = wilsonInterval(all.successes, all.count);
    if (counted.size() < 2) {
        return wilson;
    }
    const std::vector<double> limits = quantiles(bootstrapRates(counted), {0.025, 0.975});
    return {std::min(wilson.low, limits[0]), std::max(wilson.high, limits[1])};
}

}   // namespace angiopose::core
