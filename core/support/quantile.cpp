#include "core/support/quantile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace angiopose::core {

std::vector<double> quantiles(std::vector<double> values, const std::vector<double>& fractions)
{
    std::vector<double> result(fractions.size(), std::numeric_limits<double>::quiet_NaN());
    if (values.empty()) {
        return result;
    }
    // Uses selection, because sorting would take most of the time for a few fractions. Each rank is searched for only
    // above the previous one.
    std::size_t settled = 0;
    const auto ranked = [&](std::size_t rank) {
        const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
        const auto from = values.begin() + static_cast<std::ptrdiff_t>(rank > settled ? settled : 0);
        std::nth_element(from, place, values.end());
        settled = rank;
        return *place;
    };
    for (std::size_t k = 0; k < fractions.size(); ++k) {
        const double position = std::clamp(fractions[k], 0.0, 1.0) * static_cast<double>(values.size() - 1);
        const auto below = static_cast<std::size_t>(position);
        const std::size_t above = std::min(below + 1, values.size() - 1);
        const double share = position - static_cast<double>(below);
        // Interpolates only between ranks; otherwise an infinite neighbor would turn an exact rank into NaN.
        const double lower = ranked(below);
        result[k] = share > 0.0 ? (1.0 - share) * lower + share * ranked(above) : lower;
    }
    return result;
}

double quantile(std::vector<double> values, double fraction)
{
    return quantiles(std::move(values), {fraction}).front();
}

double medianOf(std::vector<double> values)
{
    assert(!values.empty());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}   // namespace angiopose::core
