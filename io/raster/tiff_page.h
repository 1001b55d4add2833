#pragma once

#include <tiffio.h>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace angiopose::io {

struct CloseTiff {
    void operator()(TIFF* file) const { TIFFClose(file); }
};
using TiffFile = std::unique_ptr<TIFF, CloseTiff>;

/// Tags, as stored, that determine how the pixels of one page are displayed.
struct TiffPage {
    std::uint32_t width = 0, height = 0;   ///< px
    std::uint16_t channels = 1, bits = 1, format = SAMPLEFORMAT_UINT, photometric = PHOTOMETRIC_MINISBLACK;
    std::uint16_t planes = PLANARCONFIG_CONTIG, compression = COMPRESSION_NONE, orientation = ORIENTATION_TOPLEFT;

    bool isGray() const;   ///< whether the page is grayscale, optionally with alpha
    bool isColor() const;   ///< whether the page is red, green, blue, optionally with alpha
    bool isPalette() const;   ///< whether the page uses a 256-color palette
    std::size_t rowBytes() const { return std::size_t{width} * channels * bits / 8; }
};

/// Describes the current page. Returns nullopt unless the samples are interleaved 8-bit, 16-bit or float values of
/// grayscale, color or palette indices and the page is no larger than the largest detector.
std::optional<TiffPage> readTiffPage(TIFF* file);

/// Returns whether the current page is a reduced version or a mask of another page; false for the only page.
bool isAuxiliaryPage(TIFF* file);

}   // namespace angiopose::io
