#pragma once

#include "core/imaging/image2d.h"
#include "io/movie/movie_writer.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace angiopose::io {

/// An image in the format of video codecs: luma and, at half the resolution, two chroma planes; ITU-R BT.709, limited
/// range (16…235), chroma sited at the left of two columns.
struct PlanarPicture {
    int width = 0;   ///< even
    int height = 0;   ///< even
    std::vector<std::uint8_t> luma;
    std::vector<std::uint8_t> blue;   ///< Cb
    std::vector<std::uint8_t> red;   ///< Cr
};

/// Converts an image; an odd side is padded by repeating its last column or row.
PlanarPicture planarPicture(const core::ColorImage& picture);

/// Returns whether openh264 can encode images of this size: at most 36,864 blocks of 16 × 16 px.
bool canEncode(const MovieSize& size);

/// An encoded image: NAL units without start codes.
struct EncodedPicture {
    std::vector<std::string> units;
    bool isWhole = false;   ///< key frame: decodable without other images
};

/// Encodes H.264 of constant, high quality with openh264 in one thread: the same images give the same bytes.
class H264Encoder {
public:
    /// Creates an encoder; width and height must be even.
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
