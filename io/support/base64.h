#pragma once

#include <string>
#include <string_view>

namespace angiopose::io {

/// Bytes as letters, for files of text (RFC 4648, without line breaks).
std::string base64(std::string_view bytes);

}   // namespace angiopose::io
