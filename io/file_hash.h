#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// SHA-256 of a file's content, lower-case hex. Fails naming the file when it cannot be read.
core::Result<std::string> sha256OfFile(const std::string& path);

/// SHA-256 of a text, lower-case hex.
core::Result<std::string> sha256OfText(std::string_view text);

}   // namespace angiopose::io