#pragma once

#include "io/movie/movie_writer.h"

#include <cstdint>
#include <string>
#include <vector>

namespace angiopose::io {

/// MP4 with one track of H.264; odd sizes get one column or row more. What is encoded stays in memory until `finish`.
core::Result<std::unique_ptr<MovieWriter>> createMp4(const std::string& path, const MovieSize& size,
                                                     const MovieFacts& facts);

/// One picture in a track.
struct Mp4Sample {
    std::size_t bytes = 0;
    std::uint32_t ticks = 0;   ///< how long it is shown
    bool isWhole = false;   ///< players may start here
};

/// One track of H.264 with all that a file says of it.
struct Mp4Track {
    MovieSize size;
    std::uint32_t ticksPerSecond = 90000;
    std::string sequence;   ///< SPS, PPS: NAL units 7 and 8 without start code
    std::string picture;
    std::vector<Mp4Sample> samples;
    MovieFacts facts;
};

/// What stands before the pictures in a file that can be played while it is read (ISO/IEC 14496-12 and -15: ftyp, moov,
/// head of mdat); the samples follow in their order, NAL units with their lengths in four bytes before them. Needs less
/// than 4 GB of samples.
std::string mp4Head(const Mp4Track& track);

}   // namespace angiopose::io
