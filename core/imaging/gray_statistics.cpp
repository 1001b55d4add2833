#include "core/imaging/gray_statistics.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace angiopose::core {
namespace {

constexpr std::size_t minHistogramCount = 4096;   // number of values below which plain selection is as fast
constexpr int levelBits = 12;   // sign, exponent and three mantissa bits; a level spans an eighth of a factor of two

/// Returns the highest bits of a value, reordered to increase with the value.
std::size_t levelOf(float value)
{
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t ordered = bits ^ ((bits >> 31U) != 0U ? 0xffffffffU : 0x80000000U);
    return ordered >> (32 - levelBits);
}

std::size_t rankOf(double fraction, std::size_t count)
{
    return static_cast<std::size_t>(fraction * static_cast<double>(count - 1));
}

std::vector<std::size_t> levelHistogram(const std::vector<float>& values)
{
    std::vector<std::size_t> counts(std::size_t{1} << levelBits);
    for (const float value : values) {
        ++counts[levelOf(value)];
    }
    return counts;
}

/// Returns the value with this rank by selecting among the values of one level.
float valueAtRank(const std::vector<float>& values, const std::vector<std::size_t>& counts, std::size_t rank)
{
    std::size_t level = 0;
    while (rank >= counts[level]) {
        rank -= counts[level];
        ++level;
    }
    std::vector<float> inLevel;
    inLevel.reserve(counts[level]);
    std::ranges::copy_if(values, std::back_inserter(inLevel), [level](float value) { return levelOf(value) == level; });
    const auto place = inLevel.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(inLevel.begin(), place, inLevel.end());
    return *place;
}

std::vector<float> quantilesBySelection(std::vector<float> values, const std::vector<double>& fractions)
{
    std::vector<float> found;
    auto searchBegin = values.begin();   // no value before this position is greater than one after it
    for (const double fraction : fractions) {
        const auto place = values.begin() + static_cast<std::ptrdiff_t>(rankOf(fraction, values.size()));
        std::nth_element(searchBegin, place, values.end());
        found.push_back(*place);
        searchBegin = place;
    }
    return found;
}

}   // namespace

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
        const double between = below * (total - below) * gap * gap;   // between-class variance up to a constant factor
        if (between > widestGap) {
            widestGap = between;
            best = bin + 1;
        }
    }
    return static_cast<float>(best) / (binCount - 1) * top;
}

std::vector<float> subsample(const std::vector<float>& values, std::size_t maxCount)
{
    const std::size_t step = std::max<std::size_t>(1, (values.size() + maxCount - 1) / maxCount);
    std::vector<float> sample;
    sample.reserve(values.size() / step + 1);
    for (std::size_t i = 0; i < values.size(); i += step) {
        sample.push_back(values[i]);
    }
    return sample;
}

float grayQuantile(std::vector<float> values, double fraction)
{
    return grayQuantiles(std::move(values), {fraction}).front();
}

std::vector<float> grayQuantiles(std::vector<float> values, const std::vector<double>& fractions)
{
    assert(!values.empty());
    if (values.size() < minHistogramCount) {
        return quantilesBySelection(std::move(values), fractions);
    }
    const std::vector<std::size_t> counts = levelHistogram(values);
    std::vector<float> found;
    for (const double fraction : fractions) {
        found.push_back(valueAtRank(values, counts, rankOf(fraction, values.size())));
    }
    return found;
}

}   // namespace angiopose::core
