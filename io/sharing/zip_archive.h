#pragma once

#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Writes the files of a folder and its subfolders into a ZIP archive, atomically, under their relative paths, sorted
/// by path and with one fixed date: the same files give the same bytes.
core::Status writeZip(const std::string& folder, const std::string& archive);

}   // namespace angiopose::io
