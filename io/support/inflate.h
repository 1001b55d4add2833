#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

enum class Packing { Gzip, RawDeflate };

/// Unpacked content; nothing when it is damaged, cut short or grows beyond `maxBytes`.
std::optional<std::string> inflated(std::string_view packed, Packing packing, std::size_t maxBytes);

/// The first `bytes` of a gzip archive's content, or as many as can be had.
std::string inflatedStart(std::string_view packed, std::size_t bytes);

}   // namespace angiopose::io