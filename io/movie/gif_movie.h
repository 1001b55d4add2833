#pragma once

#include "io/movie/movie_writer.h"

namespace angiopose::io {

inline constexpr int maxGifSidePx = 8192;   ///< the format has 65,535; nobody shows that
inline constexpr int minMovieSidePx = 16;

/// GIF by giflib: starts again for ever, delays of whole 1/100 s, each picture with colours of its own and only where
/// it differs from the one before.
core::Result<std::unique_ptr<MovieWriter>> createGif(const std::string& path, const MovieSize& size,
                                                     const MovieFacts& facts);

}   // namespace angiopose::io
