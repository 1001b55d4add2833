#pragma once

#include "core/support/result.h"
#include "io/dicom/dicom_file.h"

#include <string>

namespace angiopose::io {

/// Storage format of the pixels (Image Pixel Module, PS3.3 C.7.6.3); all values are validated.
struct PixelLayout {
    int rows = 0;
    int columns = 0;
    int frames = 1;
    int samples = 1;   ///< samples per pixel: 1 (grayscale) or 3 (color)
    int bitsAllocated = 16;
    int bitsStored = 16;
    int highBit = 15;
    bool isSigned = false;
    bool isPlanar = false;   ///< whether color planes are stored one after another
    bool isFloat = false;   ///< whether the pixels are stored as Float Pixel Data
    std::string photometric;   ///< photometric interpretation: "MONOCHROME2", "RGB", "YBR_FULL_422", …

    std::size_t pixelsPerFrame() const { return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns); }
};

/// Maximum number of pixels in all frames of a cine run, which are held in memory as float.
inline constexpr std::size_t maxRunPixels = 220'000'000;
inline constexpr std::size_t maxFramePixels = std::size_t{8192} * 8192;

/// Reads the layout; fails if the file contains no image, an image that AngioPose cannot display, or more than
/// `maxPixels` pixels in all frames.
core::Result<PixelLayout> pixelLayoutOf(const DicomFile& file, const std::string& path,
                                        std::size_t maxPixels = maxRunPixels);

}   // namespace angiopose::io
