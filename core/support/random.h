#pragma once

#include <cstdint>

namespace angiopose::core {

/// Seeded counter-based generator (SplitMix64): the n-th draw depends only on seed and n, on every platform.
/// Satisfies UniformRandomBitGenerator.
class CounterRandom {
public:
    using result_type = std::uint64_t;

    explicit CounterRandom(std::uint64_t seed) : seed_(seed) {}

    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return ~result_type{0}; }
    result_type operator()();

    double uniform();   ///< in [0, 1)
    double uniform(double low, double high);   ///< in [low, high)
    double normal();   ///< mean 0, standard deviation 1
    int index(int count);   ///< in {0, …, count-1}, count > 0
    std::uint64_t poisson(double mean);   ///< mean ≥ 0; normal approximation above 50

    /// Returns an independent generator for subtask `stream` (a trial, a frame, a branch).
    CounterRandom fork(std::uint64_t stream) const;

private:
    std::uint64_t seed_;
    std::uint64_t counter_ = 0;
};

}   // namespace angiopose::core
