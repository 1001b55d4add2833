#include "io/raster/png_text.h"

#include <png.h>
#include <cmath>
#include <stdexcept>

namespace angiopose::io {
namespace {

constexpr std::size_t maxKeyword = 79;   // maximum keyword length (PNG §11.3.4)
constexpr double metersPerInch = 0.0254;
constexpr int quickLevel = 2;   // zlib compression level

[[noreturn]] void refuse(png_struct*, const char* reason)
{
    throw std::runtime_error(reason);
}

void ignore(png_struct*, const char*) {}

void append(png_struct* png, png_byte* bytes, std::size_t size)
{
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), size);
}

/// Owns libpng's write structures and frees them on every exit path.
struct PngWriter {
    png_struct* png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, refuse, ignore);
    png_info* info = png_create_info_struct(png);
    PngWriter() = default;
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
    ~PngWriter() { png_destroy_write_struct(&png, &info); }
};

void addTexts(png_struct* png, png_info* info, const std::map<std::string, std::string>& texts)
{
    for (const auto& [keyword, text] : texts) {
        const std::string key = keyword.substr(0, maxKeyword);
        png_text entry{};
        entry.compression = PNG_ITXT_COMPRESSION_NONE;
        entry.key = const_cast<char*>(key.c_str());
        entry.text = const_cast<char*>(text.c_str());
        entry.itxt_length = text.size();
        png_set_text(png, info, &entry, 1);   // libpng copies the text
    }
}

}   // namespace

std::string encodePng(const PngPixels& pixels, const std::map<std::string, std::string>& texts)
{
    std::string content;
    const PngWriter writer;
    png_struct* png = writer.png;
    png_info* info = writer.info;
    const auto channels = static_cast<std::size_t>(pixels.channels);
    png_set_write_fn(png, &content, append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(pixels.width), static_cast<png_uint_32>(pixels.height),
                 pixels.bitDepth, channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (channels == 3) {
        png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    }
    if (pixels.dotsPerInch > 0.0) {
        const auto perMeter = static_cast<png_uint_32>(std::lround(pixels.dotsPerInch / metersPerInch));
        png_set_pHYs(png, info, perMeter, perMeter, PNG_RESOLUTION_METER);
    }
    addTexts(png, info, texts);
    // For overlays, these settings produce files as small as the default level in a fifth of the time (measured, D90).
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_compression_level(png, quickLevel);
    png_set_compression_strategy(png, 0);   // default strategy, which libpng selects for numeric data
    png_write_info(png, info);
    const std::size_t rowBytes =
        static_cast<std::size_t>(pixels.width) * channels * static_cast<std::size_t>(pixels.bitDepth / 8);
    for (std::size_t y = 0; y < static_cast<std::size_t>(pixels.height); ++y) {
        png_write_row(png, pixels.bytes->data() + y * rowBytes);
    }
    png_write_end(png, info);
    return content;
}

}   // namespace angiopose::io
