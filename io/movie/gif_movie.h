#pragma once

#include "io/movie/movie_writer.h"

namespace angiopose::io {

inline constexpr int maxGifSidePx = 8192;   ///< the format permits 65,535, more than any display can show
inline constexpr int minMovieSidePx = 16;

/// Creates a GIF through giflib: endless loop, delays in multiples of 1/100 s, a local palette per image; stores only
/// the region that differs from the previous image.
core::Result<std::unique_ptr<MovieWriter>> createGif(const std::string& path, const MovieSize& size,
                                                     const MovieMetadata& facts);

}   // namespace angiopose::io
