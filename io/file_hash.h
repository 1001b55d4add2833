#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns the SHA-256 of a file's content in lower-case hex. If the file cannot be read, fails and names the file.
core::Result<std::string> sha256OfFile(const std::string& path);

/// Returns the SHA-256 of a text in lower-case hex.
core::Result<std::string> sha256OfText(std::string_view text);

}   // namespace angiopose::io
