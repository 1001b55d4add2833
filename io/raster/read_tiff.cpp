#include "io/raster/read_tiff.h"

#include "io/messages/messages.h"
#include "io/raster/image_orientation.h"
#include "io/raster/tiff_page.h"
#include "io/support/file_error.h"

#include <tiffio.h>
#include <cstring>

namespace angiopose::io {
namespace {

constexpr std::size_t maxTiffPixels = 100'000'000;
constexpr std::uint32_t smallestPageSide = 8;

/// Whether a page can be an angiogram: grayscale or color, and of plausible size.
bool isPicture(const TiffPage& page)
{
    return (page.isGray() || page.isColor()) && page.width >= smallestPageSide && page.height >= smallestPageSide &&
           std::size_t{page.width} * page.height <= maxTiffPixels;
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

float grayAt(const std::vector<unsigned char>& row, std::size_t x, const TiffPage& page, Raster& raster)
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
    std::vector<unsigned char> row(page.rowBytes());
    for (std::uint32_t y = 0; y < page.height; ++y) {
        if (TIFFReadScanline(file, row.data(), y, 0) != 1) {
            return false;
        }
        for (std::uint32_t x = 0; x < page.width; ++x) {
            frame.at(static_cast<int>(x), static_cast<int>(y)) = grayAt(row, x, page, raster);
        }
    }
    raster.hadAlpha |= page.channels == 2 || page.channels == 4;
    if (page.orientation != ORIENTATION_TOPLEFT) {
        raster.orientation = page.orientation;
        frame = applyOrientation(frame, page.orientation);
    }
    raster.frames.push_back(std::move(frame));
    return true;
}

}   // namespace

core::Result<Raster> readTiff(const std::string& path)
{
    const TiffFile file(TIFFOpen(path.c_str(), "r"));
    Raster raster;
    std::size_t pixels = 0;
    for (bool hasPage = file != nullptr; hasPage; hasPage = TIFFLastDirectory(file.get()) == 0) {
        if (pixels > 0 && TIFFReadDirectory(file.get()) != 1) {
            return fileError(path, messages::imageDamaged());
        }
        const auto page = readTiffPage(file.get());
        pixels += page ? std::size_t{page->width} * page->height : 1;
        if (isAuxiliaryPage(file.get())) {
            continue;
        }
        if (!page || !isPicture(*page) || pixels > maxTiffPixels || !appendPage(file.get(), *page, raster)) {
            return fileError(path, messages::imageUnusual());
        }
        const core::ImageF &first = raster.frames.front(), &last = raster.frames.back();
        if (last.width != first.width || last.height != first.height) {
            return fileError(path, messages::imagePagesDiffer(raster.frames.size(), last.width, last.height,
                                                              first.width, first.height));
        }
    }
    return raster.frames.empty() ? core::Result<Raster>(fileError(path, messages::imageUnusual())) : raster;
}

}   // namespace angiopose::io
