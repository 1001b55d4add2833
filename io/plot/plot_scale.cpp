#include "io/plot/plot_scale.h"

#include "core/support/format_number.h"

#include <algorithm>
#include <cmath>

namespace angiopose::io {
namespace {

constexpr double mostTicks = 8.0;

/// "1e-4", but "0.01" … "1000" as they are.
std::string powerOfTen(int exponent)
{
    return exponent >= -2 && exponent <= 3 ? core::plainText(std::pow(10.0, exponent))
                                           : "1e" + std::to_string(exponent);
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
    const double clipped = std::clamp(value, axis_.min, axis_.max);
    return from_ + (to_ - from_) * (along(clipped) - along(axis_.min)) / (along(axis_.max) - along(axis_.min));
}

std::vector<PlotTick> PlotScale::ticks() const
{
    if (!(axis_.max > axis_.min)) {
        return {};
    }
    return axis_.isLogarithmic ? logarithmicTicks(axis_) : linearTicks(axis_);
}

}   // namespace angiopose::io