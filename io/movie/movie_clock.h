#pragma once

#include <cmath>
#include <cstdint>

namespace angiopose::io {

/// Times of pictures that follow each other, in whole ticks: each is rounded for itself, so that errors do not add up.
class MovieClock {
public:
    explicit MovieClock(double ticksPerSecond) : ticksPerMs_(ticksPerSecond / 1000.0) {}

    std::int64_t now() const { return std::llround(ticksPerMs_ * elapsedMs_); }
    void advance(double ms) { elapsedMs_ += ms; }

private:
    double ticksPerMs_;
    double elapsedMs_ = 0.0;
};

}   // namespace angiopose::io
