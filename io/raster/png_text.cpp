#include "io/raster/png_text.h"

#include <zlib.h>
#include <string_view>

namespace angiopose::io {
namespace {

constexpr std::size_t maxKeyword = 79;   // PNG §11.3.4

void appendUint32(std::string& text, std::uint32_t value)
{
    for (int shift = 24; shift >= 0; shift -= 8) {
        text += static_cast<char>(value >> shift & 0xff);
    }
}

void appendChunk(std::string& png, std::string_view type, std::string_view data)
{
    appendUint32(png, static_cast<std::uint32_t>(data.size()));
    const std::string body = std::string(type) + std::string(data);
    png += body;
    appendUint32(png, static_cast<std::uint32_t>(
                          crc32_z(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<z_size_t>(body.size()))));
}

/// Rows with the filter "difference to the pixel on the left", which suits images and flat areas alike.
std::string filteredRows(const PngPixels& pixels)
{
    const auto channels = static_cast<std::size_t>(pixels.channels);
    const std::size_t rowBytes = static_cast<std::size_t>(pixels.width) * channels;
    std::string rows;
    rows.reserve((rowBytes + 1) * static_cast<std::size_t>(pixels.height));
    for (std::size_t y = 0; y < static_cast<std::size_t>(pixels.height); ++y) {
        const std::uint8_t* row = pixels.bytes->data() + y * rowBytes;
        rows += '\x01';
        for (std::size_t i = 0; i < rowBytes; ++i) {
            rows += static_cast<char>(row[i] - (i >= channels ? row[i - channels] : 0));
        }
    }
    return rows;
}

std::string compressed(const std::string& content)
{
    uLongf size = compressBound(static_cast<uLong>(content.size()));
    std::string packed(size, '\0');
    compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(content.data()),
              static_cast<uLong>(content.size()), 6);
    packed.resize(size);
    return packed;
}

}   // namespace

std::string encodedPng(const PngPixels& pixels, const std::map<std::string, std::string>& texts)
{
    std::string png = "\x89PNG\r\n\x1a\n";
    std::string header;
    appendUint32(header, static_cast<std::uint32_t>(pixels.width));
    appendUint32(header, static_cast<std::uint32_t>(pixels.height));
    header += '\x08';
    header += pixels.channels == 3 ? '\x02' : '\0';
    header += std::string(3, '\0');   // deflate, adaptive filters, not interlaced
    appendChunk(png, "IHDR", header);
    if (pixels.channels == 3) {
        appendChunk(png, "sRGB", std::string(1, '\0'));
    }
    for (const auto& [keyword, text] : texts) {
        // keyword, not compressed, no language, no translated keyword
        appendChunk(png, "iTXt", keyword.substr(0, maxKeyword) + std::string(5, '\0') + text);
    }
    appendChunk(png, "IDAT", compressed(filteredRows(pixels)));
    appendChunk(png, "IEND", "");
    return png;
}

}   // namespace angiopose::io