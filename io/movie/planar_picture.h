#pragma once

#include "core/imaging/image2d.h"
#include "io/movie/movie_writer.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace angiopose::io {

/// A picture as video codecs take it: brightness and, at half the resolution, two colour differences; ITU-R BT.709, the
/// narrow range (16…235), colours where the left of two columns is.
struct PlanarPicture {
    int width = 0;   ///< even
    int height = 0;   ///< even
    std::vector<std::uint8_t> luma;
    std::vector<std::uint8_t> blue;   ///< Cb
    std::vector<std::uint8_t> red;   ///< Cr
};

/// Where a side is odd, its last column or row is there twice.
PlanarPicture planarPicture(const core::ColorImage& picture);

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
