#pragma once

#include <string>
#include <string_view>

namespace angiopose::io {

/// Encodes bytes as Base64 (RFC 4648, without line breaks).
std::string base64(std::string_view bytes);

}   // namespace angiopose::io
