#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

enum class Packing { Gzip, RawDeflate };

/// Returns the unpacked content; nullopt if it is damaged, truncated or larger than `maxBytes`.
std::optional<std::string> inflated(std::string_view packed, Packing packing, std::size_t maxBytes);

/// Returns the first `bytes` of a gzip archive's content, or as many as can be unpacked.
std::string inflatedStart(std::string_view packed, std::size_t bytes);

}   // namespace angiopose::io