#pragma once

#include "core/support/result.h"
#include "io/dicom/dicom_file.h"

#include <string>

namespace angiopose::io {

/// The storage format of the pixels (Image Pixel Module, PS3.3 C.7.6.3), checked for valid values.
struct PixelLayout {
    int rows = 0;
    int columns = 0;
    int frames = 1;
    int samples = 1;   ///< 1 gray, 3 color
    int bitsAllocated = 16;
    int bitsStored = 16;
    int highBit = 15;
    bool isSigned = false;
    bool isPlanar = false;   ///< color planes one after another
    bool isFloat = false;   ///< Float Pixel Data
    std::string photometric;   ///< "MONOCHROME2", "RGB", "YBR_FULL_422", …

    std::size_t pixelsPerFrame() const { return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns); }
};

/// Maximum number of pixels of a cine run in memory, where frames are stored as float.
inline constexpr std::size_t maxRunPixels = 220'000'000;
inline constexpr std::size_t maxFramePixels = std::size_t{8192} * 8192;

/// Reads the layout; fails if the file holds no image, one that this program cannot show, or more than `maxPixels` in
/// all frames.
core::Result<PixelLayout> pixelLayoutOf(const DicomFile& file, const std::string& path,
                                        std::size_t maxPixels = maxRunPixels);

}   // namespace angiopose::io