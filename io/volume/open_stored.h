#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <string>

namespace angiopose::io {

/// True for content that `openStored` understands, by the first bytes, packed ones unpacked.
bool isStoredVolume(const std::string& path);

/// Header of a volume file by the library that knows its format; fails with file, problem and remedy.
core::Result<StoredVolume> openStored(const std::string& path);

}   // namespace angiopose::io
