#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

enum class CompressionFormat { Gzip, RawDeflate };

/// Returns the decompressed content; nullopt if the data are damaged, truncated or larger than `maxBytes`.
std::optional<std::string> decompress(std::string_view compressed, CompressionFormat format, std::size_t maxBytes);

/// Returns the first `bytes` of a gzip file's contents, or as many as can be decompressed.
std::string decompressStart(std::string_view compressed, std::size_t bytes);

}   // namespace angiopose::io
