#pragma once

#include "core/imaging/image2d.h"
#include "core/support/result.h"
#include "io/dicom/pixel_layout.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// A frame as it could be decoded.
struct DecodedFrame {
    core::ImageF image;
    bool isFlawed = false;   ///< damaged in part
};

/// Decodes the frames of a DICOM file one at a time, as stored values (colour as luminance). The file must outlive it.
class FrameReader {
public:
    /// Fails when there is no whole frame: a part of an image is no image.
    static core::Result<FrameReader> open(const DicomFile& file, const PixelLayout& layout, const std::string& path);

    /// The frames that are there, whatever the header announces.
    int frameCount() const { return frameCount_; }

    /// Frame `index`; fails when it is not there, or cannot be decoded whole.
    core::Result<core::ImageF> frame(int index) const;
    /// The same where a part of a frame is better than none.
    core::Result<DecodedFrame> wholeOrPart(int index) const;

private:
    FrameReader(PixelLayout layout, std::string path);
    core::Error undecodable(int index) const;
    core::ImageF nativeFrame(std::size_t index) const;
    core::Result<DecodedFrame> compressedFrame(std::size_t index) const;

    PixelLayout layout_;
    int frameCount_ = 0;
    std::string path_;
    std::string transferSyntax_;
    DicomPixels pixels_;
    std::vector<std::vector<std::string_view>> streams_;   ///< fragments of each compressed frame
};

/// All frames of a run that are there.
struct DecodedRun {
    std::vector<core::ImageF> frames;
    std::vector<int> flawedFrames;   ///< those damaged in part
    std::vector<int> lostFrames;   ///< those that cannot be decoded: copies of a neighbour stand in their places
};

/// Fails when no frame can be decoded.
core::Result<DecodedRun> readFrames(const DicomFile& file, const PixelLayout& layout, const std::string& path);

}   // namespace angiopose::io