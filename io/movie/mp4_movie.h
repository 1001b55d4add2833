#pragma once

#include "io/movie/movie_writer.h"

namespace angiopose::io {

/// MP4 with one track of H.264; odd sizes get one column or row more. What is encoded stays in memory until `finish`.
core::Result<std::unique_ptr<MovieWriter>> createMp4(const std::string& path, const MovieSize& size,
                                                     const MovieFacts& facts);

}   // namespace angiopose::io
