#include "core/evaluation/statistics/proportion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace angiopose::core {

Interval wilsonInterval(int successes, int count, double z)
{
    if (count <= 0) {
        return {};
    }
    const double n = count;
    const double share = successes / n;
    const double centre = share + z * z / (2.0 * n);
    const double spread = z * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
    const double scale = 1.0 + z * z / n;
    // The limits at the ends are exact; rounding must not leave them.
    return {successes == 0 ? 0.0 : (centre - spread) / scale, successes == count ? 1.0 : (centre + spread) / scale};
}

std::vector<double> holmAdjusted(const std::vector<double>& pValues)
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

}   // namespace angiopose::core