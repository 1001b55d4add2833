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

/// What says how the pixels of one page are shown; all numbers, as the tags hold them.
struct TiffPage {
    std::uint32_t width = 0, height = 0;   ///< px
    std::uint16_t channels = 1, bits = 1, format = SAMPLEFORMAT_UINT, photometric = PHOTOMETRIC_MINISBLACK;
    std::uint16_t planes = PLANARCONFIG_CONTIG, compression = COMPRESSION_NONE, orientation = ORIENTATION_TOPLEFT;

    bool isGray() const;   ///< perhaps with an opacity
    bool isColor() const;   ///< red, green, blue, perhaps an opacity
    bool isPalette() const;   ///< of 256 colours
    std::size_t rowBytes() const { return std::size_t{width} * channels * bits / 8; }
};

/// Of the page that is open. None where its rows are not samples of 8 or 16 bits or of float, side by side, grey, in
/// colours or by palette, or where it is larger than any detector.
std::optional<TiffPage> pageOf(TIFF* file);

/// Whether the page that is open is a smaller version or the mask of another one, not the only page.
bool isAside(TIFF* file);

}   // namespace angiopose::io
