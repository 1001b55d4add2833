#pragma once

#include "io/movie/movie_writer.h"

namespace angiopose::io {

/// Creates an MP4 with one H.264 track; odd sizes are padded by one column or row. The encoded data remain in memory
/// until `finish`.
core::Result<std::unique_ptr<MovieWriter>> createMp4(const std::string& path, const MovieSize& size,
                                                     const MovieMetadata& metadata);

}   // namespace angiopose::io
