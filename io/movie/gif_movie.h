#pragma once

#include "io/movie/movie_writer.h"

#include <cmath>
#include <cstdint>

namespace angiopose::io {

inline constexpr int mostGifSidePx = 8192;   ///< the format has 65,535; nobody shows that
inline constexpr int leastMovieSidePx = 16;

/// GIF by giflib: starts again for ever, delays of whole 1/100 s, each picture with colours of its own and only where
/// it differs from the one before.
core::Result<std::unique_ptr<MovieWriter>> createGif(const std::string& path, const MovieSize& size,
                                                     const MovieFacts& facts);

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
