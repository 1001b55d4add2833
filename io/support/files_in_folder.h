#pragma once

#include "core/support/result.h"

#include <string>
#include <vector>

namespace angiopose::io {

enum class Reach { FolderOnly, Below };

/// Regular files in a folder (and some levels below it), by name, without an index of a disc (DICOMDIR). Fails where it
/// cannot be read, or holds more files than any study.
core::Result<std::vector<std::string>> filesInFolder(const std::string& folder, Reach reach);

}   // namespace angiopose::io
