#include "core/evaluation/statistics/clustered_share.h"

#include "core/support/quantile.h"
#include "core/support/random.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr int bootstrapDraws = 2000;
constexpr std::uint64_t bootstrapSeed = 1;

/// Shares of trees drawn with replacement.
std::vector<double> drawnShares(const std::vector<ClusterCount>& trees)
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
    const std::vector<double> limits = quantiles(drawnShares(counted), {0.025, 0.975});
    return {std::min(wilson.low, limits[0]), std::max(wilson.high, limits[1])};
}

}   // namespace angiopose::core
