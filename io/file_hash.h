#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns the SHA-256 of a file's contents in lower-case hex. Fails and names the file if it cannot be read.
core::Result<std::string> sha256OfFile(const std::string& path);

/// Returns the SHA-256 of a string in lower-case hex.
core::Result<std::string> sha256OfText(std::string_view text);

}   // namespace angiopose::io
