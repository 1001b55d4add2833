#pragma once

#include "core/support/result.h"
#include "io/dicom/dicom_file.h"

#include <string>

namespace angiopose::io {

/// How the pixels are stored (Image Pixel Module, PS3.3 C.7.6.3), checked for values that can be.
struct PixelLayout {
    int rows = 0;
    int columns = 0;
    int frames = 1;
    int samples = 1;   ///< 1 grey, 3 colour
    int bitsAllocated = 16;
    int bitsStored = 16;
    int highBit = 15;
    bool isSigned = false;
    bool isPlanar = false;   ///< colour planes one after the other
    bool isFloat = false;   ///< Float Pixel Data
    std::string photometric;   ///< "MONOCHROME2", "RGB", "YBR_FULL_422", …

    std::size_t pixelsPerFrame() const { return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns); }
};

/// Larger runs do not fit: a frame is kept as float.
inline constexpr std::size_t maxRunPixels = 220'000'000;
inline constexpr std::size_t maxFramePixels = std::size_t{8192} * 8192;

/// Fails when the file holds no image, or one this program cannot show, or more than `maxPixels` in all its frames.
core::Result<PixelLayout> pixelLayoutOf(const DicomFile& file, const std::string& path,
                                        std::size_t maxPixels = maxRunPixels);

}   // namespace angiopose::io