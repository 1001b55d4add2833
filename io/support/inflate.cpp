#include "io/support/inflate.h"

#include <zlib.h>
#include <algorithm>
#include <array>

namespace angiopose::io {

std::optional<std::string> decompress(std::string_view compressed, CompressionFormat format, std::size_t maxBytes)
{
    z_stream stream{};
    // zlib windowBits: 15 with +16 for a gzip header; negative for raw deflate data.
    if (compressed.size() > maxBytes ||
        inflateInit2(&stream, format == CompressionFormat::Gzip ? 15 + 16 : -15) != Z_OK) {
        return std::nullopt;
    }
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.data()));
    stream.avail_in = static_cast<uInt>(compressed.size());
    std::string content;
    std::array<char, 1 << 16> block;
    int status = Z_OK;
    while (status == Z_OK && content.size() <= maxBytes) {
        stream.next_out = reinterpret_cast<Bytef*>(block.data());
        stream.avail_out = static_cast<uInt>(block.size());
        status = inflate(&stream, Z_NO_FLUSH);
        content.append(block.data(), block.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    if (status != Z_STREAM_END || content.size() > maxBytes) {
        return std::nullopt;
    }
    return content;
}

std::string decompressStart(std::string_view compressed, std::size_t bytes)
{
    z_stream stream{};
    if (inflateInit2(&stream, 15 + 16) != Z_OK) {
        return {};
    }
    std::string content(bytes, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.data()));
    stream.avail_in = static_cast<uInt>(std::min<std::size_t>(compressed.size(), 2 * bytes + 4096));
    stream.next_out = reinterpret_cast<Bytef*>(content.data());
    stream.avail_out = static_cast<uInt>(content.size());
    inflate(&stream, Z_SYNC_FLUSH);
    content.resize(bytes - stream.avail_out);
    inflateEnd(&stream);
    return content;
}

}   // namespace angiopose::io
