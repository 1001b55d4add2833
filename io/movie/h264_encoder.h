#pragma once

#include "io/movie/movie_writer.h"
#include "io/movie/planar_picture.h"

#include <memory>
#include <string>
#include <vector>

namespace angiopose::io {

/// Whether openh264 makes pictures of this size: 36,864 blocks of 16 × 16 px at most.
bool canEncode(const MovieSize& size);

/// A picture as the codec stores it: NAL units without start codes.
struct EncodedPicture {
    std::vector<std::string> units;
    bool isWhole = false;   ///< needs no other picture
};

/// H.264 of constant, high quality by openh264, one thread: the same pictures make the same bytes.
class H264Encoder {
public:
    /// Even sizes.
    static core::Result<H264Encoder> create(const MovieSize& size);
    H264Encoder(H264Encoder&&) noexcept;
    H264Encoder& operator=(H264Encoder&&) noexcept;
    ~H264Encoder();

    core::Result<EncodedPicture> encode(const PlanarPicture& picture, double atMs);

private:
    struct Parts;
    explicit H264Encoder(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::io
