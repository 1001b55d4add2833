#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <string>

namespace angiopose::io {

/// Whether `openStoredVolume` supports the file, based on its first bytes, decompressed if necessary.
bool isStoredVolume(const std::string& path);

/// Reads the header of a volume file with the library for its format. Errors name file, problem and remedy.
core::Result<StoredVolume> openStoredVolume(const std::string& path);

}   // namespace angiopose::io
