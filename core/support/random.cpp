#include "core/support/random.h"

#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

std::uint64_t mix(std::uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

constexpr std::uint64_t goldenGamma = 0x9e3779b97f4a7c15ULL;

}   // namespace

CounterRandom::result_type CounterRandom::operator()()
{
    ++counter_;
    return mix(mix(seed_) + counter_ * goldenGamma);
}

double CounterRandom::uniform()
{
    return static_cast<double>((*this)() >> 11) * 0x1.0p-53;
}

double CounterRandom::uniform(double low, double high)
{
    return low + (high - low) * uniform();
}

double CounterRandom::normal()
{
    const double radius = std::sqrt(-2.0 * std::log1p(-uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

int CounterRandom::index(int count)
{
    return static_cast<int>(uniform() * count);
}

std::uint64_t CounterRandom::poisson(double mean)
{
    if (mean > 50.0) {
        return static_cast<std::uint64_t>(std::fmax(0.0, std::round(mean + std::sqrt(mean) * normal())));
    }
    const double threshold = std::exp(-mean);
    std::uint64_t events = 0;
    for (double product = uniform(); product > threshold; product *= uniform()) {
        ++events;
    }
    return events;
}

CounterRandom CounterRandom::fork(std::uint64_t stream) const
{
    return CounterRandom(mix(seed_ ^ mix(stream + goldenGamma)));
}

}   // namespace angiopose::core
