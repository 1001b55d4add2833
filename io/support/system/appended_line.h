#pragma once

#include <string>
#include <string_view>

namespace angiopose::io {

/// Appends a line to a file that several programs append to (O_APPEND, under a lock) and flushes it to disk. Creates
/// the file, for its owner only, if it does not exist. Writes either the whole line or nothing. Returns the system's
/// error text; empty on success.
std::string appendLine(const std::string& path, std::string_view line);

}   // namespace angiopose::io
