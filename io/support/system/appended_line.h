#pragma once

#include <string>
#include <string_view>

namespace angiopose::io {

/// Appends a line to a file that several programs may extend at the same time (O_APPEND, under a lock) and flushes the
/// file to disk. Creates the file, accessible only to its owner, if it does not exist. Writes the whole line or
/// nothing. Returns the system's error text, which is empty on success.
std::string appendLine(const std::string& path, std::string_view line);

}   // namespace angiopose::io
