#pragma once

#include "core/support/result.h"

#include <string>

namespace io {

/// SHA-256 of a file's content, lower-case hex. Fails naming the file when it cannot be read.
core::Result<std::string> sha256OfFile(const std::string& path);

}   // namespace io
