#include "io/raster/read_raster.h"

#include "io/messages/messages.h"
#include "io/raster/image_orientation.h"
#include "io/raster/read_jpeg.h"
#include "io/raster/tiff_page.h"
#include "io/support/file_error.h"
#include "io/support/silence_libraries.h"

#include <png.h>
#include <tiffio.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>

namespace angiopose::io {
namespace {

constexpr std::size_t maxTiffPixels = 100'000'000;
constexpr std::uint32_t smallestPageSide = 8;

/// Returns whether a page can be an angiogram: grayscale or color, and of plausible size.
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

/// Reads the pages of a TIFF as frames, except thumbnails and masks: grayscale or RGB, 8 or 16 bits or float, in
/// strips. Fails for any other kind of TIFF, for pages of different sizes, and for files that are damaged or too large.
/// Uses libtiff directly, because ITK's reader does not detect a damaged directory.
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

constexpr std::size_t maxPngBytes = std::size_t{800} << 20;   // bytes of the decoded samples plus their float copy
constexpr std::size_t maxPngSide = 32'768;
constexpr std::size_t minPngSide = 8;

/// Error callback of libpng, which exits by longjmp: functions that it may leave must not own objects with destructors.
void leave(png_struct* png, const char*)
{
    png_longjmp(png, 1);
}

void saySilently(png_struct*, const char*) {}

void takeBytes(png_struct* png, png_byte* bytes, std::size_t size)
{
    auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
    if (size > rest.size()) {
        png_error(png, "cut short");
    }
    std::memcpy(bytes, rest.data(), size);
    rest.remove_prefix(size);
}

/// Owns libpng's read structures and frees them on every exit path.
struct PngReader {
    png_struct* png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, saySilently);
    png_info* info = png_create_info_struct(png);
    PngReader() = default;
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// Reads the header and configures rows of 8- or 16-bit grayscale or color, with alpha if the image has transparency.
bool readHeader(png_struct* png, png_info* info, std::string_view* rest)
{
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_set_read_fn(png, rest, takeBytes);
    png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_read_info(png, info);
    png_set_expand(png);
    if (std::endian::native == std::endian::little) {
        png_set_swap(png);
    }
    png_color_8* significantBits = nullptr;
    if (png_get_sBIT(png, info, &significantBits) != 0) {
        png_set_shift(png, significantBits);
    }
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return true;
}

bool readRows(png_struct* png, png_byte** rows)
{
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_read_image(png, rows);
    png_read_end(png, nullptr);
    return true;
}

template <class Sample>
Raster grayFrom(const std::vector<png_byte>& bytes, int width, int height, std::size_t channels)
{
    const auto* samples = reinterpret_cast<const Sample*>(bytes.data());
    Raster raster;
    raster.hadAlpha = channels == 2 || channels == 4;
    for (float& value : raster.frames.emplace_back(width, height).pixels) {
        value = channels < 3 ? samples[0] : raster.luminance(samples[0], samples[1], samples[2]);
        samples += channels;
    }
    return raster;
}

/// Decodes a PNG of any kind through libpng. Fails if a checksum is wrong, the file is truncated, or the image is too
/// small or too large; allocates memory only after checking the header against the size limits.
core::Result<Raster> readPng(std::string_view content, const std::string& path)
{
    const PngReader reader;
    if (!readHeader(reader.png, reader.info, &content)) {
        return fileError(path, messages::imageDamaged());
    }
    const std::size_t width = png_get_image_width(reader.png, reader.info);
    const std::size_t height = png_get_image_height(reader.png, reader.info);
    const std::size_t rowBytes = png_get_rowbytes(reader.png, reader.info);
    if (width < minPngSide || height < minPngSide || width > maxPngSide || height > maxPngSide ||
        height * (rowBytes + width * sizeof(float)) > maxPngBytes) {
        return fileError(path, messages::imageSize());
    }
    try {
        std::vector<png_byte> bytes(height * rowBytes);
        std::vector<png_byte*> rows;
        for (std::size_t y = 0; y < height; ++y) {
            rows.push_back(bytes.data() + y * rowBytes);
        }
        if (!readRows(reader.png, rows.data())) {
            return fileError(path, messages::imageDamaged());
        }
        const std::size_t channels = png_get_channels(reader.png, reader.info);
        const bool isWide = png_get_bit_depth(reader.png, reader.info) == 16;
        const auto gray = isWide ? grayFrom<std::uint16_t> : grayFrom<std::uint8_t>;
        return gray(bytes, static_cast<int>(width), static_cast<int>(height), channels);
    } catch (const std::bad_alloc&) {
        return fileError(path, messages::fileLargerThanMemory());
    }
}

constexpr std::string_view pngStart = "\x89PNG";
constexpr std::string_view jpegStart = "\xff\xd8\xff";
constexpr std::size_t maxJpegTrailer = 4096;

/// Returns whether a JPEG is truncated; libjpeg would fill the missing part with gray.
bool isTruncated(std::string_view jpeg)
{
    const std::size_t end = jpeg.rfind("\xff\xd9");
    return end == std::string_view::npos || end + maxJpegTrailer < jpeg.size();
}

core::Result<Raster> decode(std::string_view content, const std::string& path)
{
    if (content.starts_with(pngStart)) {
        return readPng(content, path);
    }
    if (!content.starts_with(jpegStart)) {
        return readTiff(path);
    }
    if (isTruncated(content)) {
        return fileError(path, messages::imageDamaged());
    }
    auto raster = readJpeg(content);
    return raster ? core::Result<Raster>(std::move(*raster)) : fileError(path, messages::imageUnusual());
}

bool isFinite(const Raster& raster)
{
    return std::all_of(raster.frames.begin(), raster.frames.end(), [](const core::ImageF& frame) {
        return std::all_of(frame.pixels.begin(), frame.pixels.end(), [](float value) { return std::isfinite(value); });
    });
}

}   // namespace

float Raster::luminance(float red, float green, float blue)
{
    if (red == green && green == blue) {
        return red;
    }
    wasColor = true;
    return 0.299F * red + 0.587F * green + 0.114F * blue;
}

bool looksLikeRaster(std::string_view content)
{
    return content.starts_with(pngStart) || content.starts_with(jpegStart) ||
           content.starts_with(std::string_view("II*\0", 4)) || content.starts_with(std::string_view("MM\0*", 4));
}

core::Result<Raster> readRaster(std::string_view content, const std::string& path)
{
    silenceLibraries();
    auto decoded = decode(content, path);
    if (!decoded) {
        return decoded;
    }
    Raster raster = std::move(decoded).value();
    if (const int orientation = exifOrientation(content); orientation > 1) {
        raster.orientation = orientation;
        raster.frames.front() = applyOrientation(raster.frames.front(), orientation);
    }
    return isFinite(raster) ? core::Result<Raster>(std::move(raster)) : fileError(path, messages::imageUnusual());
}

}   // namespace angiopose::io
