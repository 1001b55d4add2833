#include "core/imaging/grey_statistics.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

namespace angiopose::core {

float otsuThreshold(const std::vector<float>& values)
{
    constexpr std::size_t binCount = 256;
    const float top = values.empty() ? 0.0F : *std::max_element(values.begin(), values.end());
    if (!(top > 0.0F)) {
        return 0.0F;
    }
    std::array<double, binCount> histogram{};
    double moment = 0.0;
    for (const float value : values) {
        const auto bin = static_cast<std::size_t>(std::max(0.0F, value / top) * (binCount - 1));
        histogram[bin] += 1.0;
        moment += static_cast<double>(bin);
    }
    const auto total = static_cast<double>(values.size());
    double below = 0.0;
    double momentBelow = 0.0;
    double widestGap = 0.0;
    std::size_t best = 0;
    for (std::size_t bin = 0; bin + 1 < binCount; ++bin) {
        below += histogram[bin];
        momentBelow += static_cast<double>(bin) * histogram[bin];
        if (below <= 0.0 || below >= total) {
            continue;
        }
        const double gap = momentBelow / below - (moment - momentBelow) / (total - below);
        const double between = below * (total - below) * gap * gap;   // class variance, up to a constant
        if (between > widestGap) {
            widestGap = between;
            best = bin + 1;
        }
    }
    return static_cast<float>(best) / (binCount - 1) * top;
}

std::vector<float> evenSample(const std::vector<float>& values, std::size_t most)
{
    const std::size_t step = std::max<std::size_t>(1, (values.size() + most - 1) / most);
    std::vector<float> sample;
    sample.reserve(values.size() / step + 1);
    for (std::size_t i = 0; i < values.size(); i += step) {
        sample.push_back(values[i]);
    }
    return sample;
}

float ranked(std::vector<float> values, double share)
{
    return rankedAt(std::move(values), {share}).front();
}

std::vector<float> rankedAt(std::vector<float> values, const std::vector<double>& shares)
{
    assert(!values.empty());
    std::vector<float> found;
    auto rest = values.begin();   // everything before is smaller
    for (const double share : shares) {
        const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
        std::nth_element(rest, place, values.end());
        found.push_back(*place);
        rest = place;
    }
    return found;
}

}   // namespace angiopose::core