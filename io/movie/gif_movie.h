#pragma once

#include "io/movie/movie_writer.h"

namespace angiopose::io {

inline constexpr int maxGifSidePx = 8192;   ///< the format allows 65,535, which no display shows
inline constexpr int minMovieSidePx = 16;

/// Creates a GIF with giflib: endless loop, delays in whole 1/100 s, a local palette per image, and only the region
/// that differs from the previous image.
core::Result<std::unique_ptr<MovieWriter>> createGif(const std::string& path, const MovieSize& size,
                                                     const MovieFacts& facts);

}   // namespace angiopose::io
