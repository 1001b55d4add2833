#include "io/plot/plot_scale.h"

#include "core/support/format_number.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace io {
namespace {

constexpr double mostTicks = 8.0;

/// "10⁻⁴", but "0.01" … "1000" as they are.
std::string powerOfTen(int exponent)
{
    if (exponent >= -2 && exponent <= 3) {
        return core::plainText(std::pow(10.0, exponent));
    }
    static constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(exponent))) {
        text += digits[static_cast<std::size_t>(digit - '0')];
    }
    return text;
}

/// 1, 2 or 5 times a power of ten, so that not too many fit into `range`.
double roundStep(double range)
{
    const double power = std::pow(10.0, std::floor(std::log10(range / mostTicks)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (range / (factor * power) <= mostTicks) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

std::vector<PlotTick> linearTicks(const core::PlotAxis& axis)
{
    const double step = roundStep(axis.max - axis.min);
    std::vector<PlotTick> ticks;
    const double first = std::ceil(axis.min / step - 1e-9) + 0.0;   // not −0
    for (double k = first; k * step <= axis.max + 1e-9 * step; k += 1.0) {
        ticks.push_back({k * step, core::plainText(k * step)});
    }
    return ticks;
}

std::vector<PlotTick> logarithmicTicks(const core::PlotAxis& axis)
{
    const int first = static_cast<int>(std::ceil(std::log10(axis.min) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(axis.max) + 1e-9));
    const int stride = std::max(1, static_cast<int>(std::ceil((last - first + 1) / mostTicks)));
    std::vector<PlotTick> ticks;
    for (int exponent = first; exponent <= last; exponent += stride) {
        ticks.push_back({std::pow(10.0, exponent), powerOfTen(exponent)});
    }
    return ticks;
}

}   // namespace

double PlotScale::position(double value) const
{
    const auto along = [this](double v) { return axis_.isLogarithmic ? std::log10(v) : v; };
    const double clipped = axis_.isLogarithmic ? std::max(value, axis_.min) : value;
    return from_ + (to_ - from_) * (along(clipped) - along(axis_.min)) / (along(axis_.max) - along(axis_.min));
}

std::vector<PlotTick> PlotScale::ticks() const
{
    if (!(axis_.max > axis_.min)) {
        return {};
    }
    return axis_.isLogarithmic ? logarithmicTicks(axis_) : linearTicks(axis_);
}

}   // namespace io
