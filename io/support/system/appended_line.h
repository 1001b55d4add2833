#pragma once

#include <string>
#include <string_view>

namespace angiopose::io {

/// Adds a line to the end of a file that several programs add to (O_APPEND, under a lock), made for its owner alone
/// where it is not there, and has it on the disk. All of the line is there or nothing of it. What the system says where
/// that cannot be; else empty.
std::string appendLine(const std::string& path, std::string_view line);

}   // namespace angiopose::io
