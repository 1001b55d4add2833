#pragma once

#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Atomically writes the files of a folder and its subfolders into a ZIP archive under their relative paths, sorted by
/// path and with a fixed date, so that equal files produce equal bytes.
core::Status writeZip(const std::string& folder, const std::string& archive);

}   // namespace angiopose::io
