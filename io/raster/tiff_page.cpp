#include "io/raster/tiff_page.h"

#include <tiffio.h>

namespace angiopose::io {
namespace {

constexpr std::uint32_t largestPageSide = 32'768;

bool isSampleKnown(const TiffPage& page)
{
    return page.format == SAMPLEFORMAT_IEEEFP ? page.bits == 32
                                              : page.format == SAMPLEFORMAT_UINT && (page.bits == 8 || page.bits == 16);
}

bool isSizePlausible(const TiffPage& page)
{
    return page.channels > 0 && page.width > 0 && page.height > 0 && page.width <= largestPageSide &&
           page.height <= largestPageSide;
}

}   // namespace

bool TiffPage::isGray() const
{
    return channels <= 2 && (photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE);
}

bool TiffPage::isColor() const
{
    return (channels == 3 || channels == 4) && photometric == PHOTOMETRIC_RGB;
}

bool TiffPage::isPalette() const
{
    return channels == 1 && photometric == PHOTOMETRIC_PALETTE && bits == 8;
}

std::optional<TiffPage> readTiffPage(TIFF* file)
{
    TiffPage page;
    TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &page.width);
    TIFFGetField(file, TIFFTAG_IMAGELENGTH, &page.height);
    TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLESPERPIXEL, &page.channels);
    TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &page.bits);
    TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLEFORMAT, &page.format);
    TIFFGetFieldDefaulted(file, TIFFTAG_PLANARCONFIG, &page.planes);
    TIFFGetFieldDefaulted(file, TIFFTAG_COMPRESSION, &page.compression);
    TIFFGetFieldDefaulted(file, TIFFTAG_ORIENTATION, &page.orientation);
    TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &page.photometric);
    const bool isReadable = (page.isGray() || page.isColor() || page.isPalette()) && isSampleKnown(page) &&
                            isSizePlausible(page) && page.planes == PLANARCONFIG_CONTIG && !TIFFIsTiled(file) &&
                            TIFFScanlineSize64(file) == page.rowBytes();
    return isReadable ? std::optional(page) : std::nullopt;
}

bool isAuxiliaryPage(TIFF* file)
{
    std::uint32_t kind = 0;
    TIFFGetFieldDefaulted(file, TIFFTAG_SUBFILETYPE, &kind);
    const bool isOnly = TIFFCurrentDirectory(file) == 0 && TIFFLastDirectory(file) != 0;
    return (kind & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) != 0 && !isOnly;
}

}   // namespace angiopose::io
