#pragma once

#include "core/imaging/image2d.h"
#include "io/movie/movie_writer.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace angiopose::io {

/// Image in the format of video codecs: one luma plane and two chroma planes of half the resolution; ITU-R BT.709,
/// limited range (16…235), chroma sited at the left of two columns.
struct YuvImage {
    int width = 0;   ///< even number
    int height = 0;   ///< even number
    std::vector<std::uint8_t> luma;
    std::vector<std::uint8_t> blue;   ///< Cb
    std::vector<std::uint8_t> red;   ///< Cr
};

/// Converts an image; an odd side is padded by repeating its last column or row.
YuvImage toYuvImage(const core::ColorImage& picture);

/// Returns whether openh264 can encode images of this size: at most 36,864 macroblocks of 16 × 16 px.
bool canEncode(const MovieSize& size);

/// An encoded image: NAL units without start codes.
struct EncodedFrame {
    std::vector<std::string> nalUnits;
    bool isKeyFrame = false;   ///< whether the image is a key frame, decodable without other images
};

/// Encodes H.264 at constant high quality through openh264 in one thread, so that equal images produce equal bytes.
class H264Encoder {
public:
    /// Creates an encoder; width and height must be even.
    static core::Result<H264Encoder> create(const MovieSize& size);
    H264Encoder(H264Encoder&&) noexcept;
    H264Encoder& operator=(H264Encoder&&) noexcept;
    ~H264Encoder();

    core::Result<EncodedFrame> encode(const YuvImage& picture, double timeMs);

private:
    struct Impl;
    explicit H264Encoder(std::unique_ptr<Impl> parts);
    std::unique_ptr<Impl> impl_;
};

}   // namespace angiopose::io
