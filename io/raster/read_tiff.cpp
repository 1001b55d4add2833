#include "io/raster/read_tiff.h"

#include <tiffio.h>
#include <cstring>
#include <memory>

namespace angiopose::io {
namespace {

constexpr std::size_t maxRunPixels = 100'000'000;
constexpr std::uint32_t minSide = 8;
constexpr std::uint32_t maxSide = 32'768;

struct CloseTiff {
    void operator()(TIFF* file) const { TIFFClose(file); }
};

/// Layout of one page.
struct TiffPage {
    std::uint32_t width = 0, height = 0;
    std::uint16_t channels = 1, bits = 1, format = SAMPLEFORMAT_UINT, photometric = PHOTOMETRIC_MINISBLACK;
    std::uint16_t planes = PLANARCONFIG_CONTIG;
};

std::optional<TiffPage> pageOf(TIFF* file)
{
    TiffPage page;
    TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &page.width);
    TIFFGetField(file, TIFFTAG_IMAGELENGTH, &page.height);
    TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLESPERPIXEL, &page.channels);
    TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &page.bits);
    TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLEFORMAT, &page.format);
    TIFFGetFieldDefaulted(file, TIFFTAG_PLANARCONFIG, &page.planes);
    TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &page.photometric);
    const bool isGrey = page.channels <= 2 &&
                        (page.photometric == PHOTOMETRIC_MINISBLACK || page.photometric == PHOTOMETRIC_MINISWHITE);
    const bool isColour = (page.channels == 3 || page.channels == 4) && page.photometric == PHOTOMETRIC_RGB;
    const bool isKnownSample = page.format == SAMPLEFORMAT_IEEEFP
                                   ? page.bits == 32
                                   : page.format == SAMPLEFORMAT_UINT && (page.bits == 8 || page.bits == 16);
    const bool isPlausible = page.width >= minSide && page.height >= minSide && page.width <= maxSide &&
                             page.height <= maxSide && std::size_t{page.width} * page.height <= maxRunPixels;
    if (!(isGrey || isColour) || !isKnownSample || !isPlausible || page.planes != PLANARCONFIG_CONTIG ||
        TIFFIsTiled(file) || page.channels == 0) {
        return std::nullopt;
    }
    const std::size_t rowBytes = std::size_t{page.width} * page.channels * page.bits / 8;
    return TIFFScanlineSize64(file) == rowBytes ? std::optional(page) : std::nullopt;
}

float sampleAt(const std::vector<unsigned char>& row, std::size_t index, const TiffPage& page)
{
    if (page.bits == 8) {
        return row[index];
    }
    if (page.bits == 16) {
        std::uint16_t value = 0;
        std::memcpy(&value, row.data() + 2 * index, sizeof value);
        return value;
    }
    float value = 0.0F;
    std::memcpy(&value, row.data() + 4 * index, sizeof value);
    return value;
}

float greyAt(const std::vector<unsigned char>& row, std::size_t x, const TiffPage& page, Raster& raster)
{
    const std::size_t first = x * page.channels;
    const float value = sampleAt(row, first, page);
    if (page.channels < 3) {
        const bool isInverted = page.photometric == PHOTOMETRIC_MINISWHITE;
        return isInverted
                   ? (page.format == SAMPLEFORMAT_IEEEFP ? 0.0F : static_cast<float>((1 << page.bits) - 1)) - value
                   : value;
    }
    return raster.luminance(value, sampleAt(row, first + 1, page), sampleAt(row, first + 2, page));
}

bool appendPage(TIFF* file, const TiffPage& page, Raster& raster)
{
    core::ImageF frame(static_cast<int>(page.width), static_cast<int>(page.height));
    std::vector<unsigned char> row(static_cast<std::size_t>(TIFFScanlineSize64(file)));
    for (std::uint32_t y = 0; y < page.height; ++y) {
        if (TIFFReadScanline(file, row.data(), y, 0) != 1) {
            return false;
        }
        for (std::uint32_t x = 0; x < page.width; ++x) {
            frame.at(static_cast<int>(x), static_cast<int>(y)) = greyAt(row, x, page, raster);
        }
    }
    raster.hadAlpha |= page.channels == 2 || page.channels == 4;
    raster.frames.push_back(std::move(frame));
    return true;
}

}   // namespace

std::optional<Raster> readTiff(const std::string& path)
{
    const std::unique_ptr<TIFF, CloseTiff> file(TIFFOpen(path.c_str(), "r"));
    Raster raster;
    std::size_t pixels = 0;
    bool hasPage = file != nullptr;
    while (hasPage) {
        const auto page = pageOf(file.get());
        pixels += page ? std::size_t{page->width} * page->height : 0;
        const bool hasOtherSize = page && !raster.frames.empty() &&
                                  (static_cast<int>(page->width) != raster.frames.front().width ||
                                   static_cast<int>(page->height) != raster.frames.front().height);
        if (!page || pixels > maxRunPixels || hasOtherSize || !appendPage(file.get(), *page, raster)) {
            return std::nullopt;
        }
        hasPage = TIFFReadDirectory(file.get()) == 1;
    }
    return raster.frames.empty() ? std::nullopt : std::optional(std::move(raster));
}

}   // namespace angiopose::io