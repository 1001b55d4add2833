#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <string>

namespace angiopose::io {

/// Returns whether `openStoredVolume` supports the file, based on its first bytes, decompressed if necessary.
bool isStoredVolume(const std::string& path);

/// Reads the header of a volume file with the library for its format. Errors name the file, the problem and the remedy.
core::Result<StoredVolume> openStoredVolume(const std::string& path);

}   // namespace angiopose::io
