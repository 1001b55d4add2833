#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

enum class Packing { Gzip, RawDeflate };

/// Unpacked content; nothing when it is damaged, cut short or grows beyond `maxBytes`.
std::optional<std::string> inflated(std::string_view packed, Packing packing, std::size_t maxBytes);

}   // namespace angiopose::io