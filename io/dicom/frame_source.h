#pragma once

#include "core/imaging/image2d.h"
#include "core/support/result.h"
#include "io/dicom/pixel_layout.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Frame decoded as far as possible.
struct DecodedFrame {
    core::ImageF image;
    bool isPartlyDamaged = false;   ///< whether the frame is partly damaged
};

/// Decodes the frames of a DICOM file one at a time to stored values (color to luminance). The file must outlive the
/// reader.
class FrameReader {
public:
    /// Opens the frames of a file; fails if the file contains no complete frame.
    static core::Result<FrameReader> open(const DicomFile& file, const PixelLayout& layout, const std::string& path);

    /// Returns the number of frames actually present, whatever the header states.
    int frameCount() const { return frameCount_; }

    /// Decodes frame `index`; fails if the frame is absent or cannot be decoded in full.
    core::Result<core::ImageF> frame(int index) const;
    /// Decodes frame `index`; also returns a frame that can be decoded only in part.
    core::Result<DecodedFrame> frameAllowingDamage(int index) const;

private:
    FrameReader(PixelLayout layout, std::string path);
    core::Error decodeError(int index) const;
    core::ImageF nativeFrame(std::size_t index) const;
    core::Result<DecodedFrame> compressedFrame(std::size_t index) const;

    PixelLayout layout_;
    int frameCount_ = 0;
    std::string path_;
    std::string transferSyntax_;
    DicomPixels pixels_;
    std::vector<std::vector<std::string_view>> streams_;   ///< fragments of each compressed frame
};

/// Decoded frames of a cine run, as many as the file contains.
struct DecodedRun {
    std::vector<core::ImageF> frames;
    std::vector<int> damagedFrames;   ///< indices of partly damaged frames
    std::vector<int> lostFrames;   ///< frames that cannot be decoded, replaced by copies of a neighboring frame
};

/// Decodes all frames; fails if none can be decoded.
core::Result<DecodedRun> readFrames(const DicomFile& file, const PixelLayout& layout, const std::string& path);

}   // namespace angiopose::io
