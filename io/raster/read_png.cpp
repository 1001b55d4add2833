#include "io/raster/read_png.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"

#include <png.h>
#include <bit>
#include <cstdint>
#include <cstring>
#include <new>

namespace angiopose::io {
namespace {

constexpr std::size_t maxBytes = std::size_t{800} << 20;   // decoded samples plus their float copy
constexpr std::size_t maxSide = 32'768;
constexpr std::size_t minSide = 8;

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

}   // namespace

core::Result<Raster> readPng(std::string_view content, const std::string& path)
{
    const PngReader reader;
    if (!readHeader(reader.png, reader.info, &content)) {
        return fileError(path, messages::imageDamaged());
    }
    const std::size_t width = png_get_image_width(reader.png, reader.info);
    const std::size_t height = png_get_image_height(reader.png, reader.info);
    const std::size_t rowBytes = png_get_rowbytes(reader.png, reader.info);
    if (width < minSide || height < minSide || width > maxSide || height > maxSide ||
        height * (rowBytes + width * sizeof(float)) > maxBytes) {
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

}   // namespace angiopose::io
