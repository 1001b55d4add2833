#pragma once

#include "core/support/result.h"

#include <string>
#include <vector>

namespace angiopose::io {

enum class FolderDepth { TopLevel, Recursive };

/// Lists the regular files of a folder (and some levels of subfolders), sorted by name, without the DICOMDIR of a disc.
/// Fails if the folder cannot be read or contains more files than any study would.
core::Result<std::vector<std::string>> filesInFolder(const std::string& folder, FolderDepth folderDepth);

}   // namespace angiopose::io
