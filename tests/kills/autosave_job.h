#pragma once

#include <string>

namespace angiopose::test {

/// Lets a session autosave the case in `folder` until the process is killed; the copies are in `dataFolderOf(folder)`.
int autosaveForEver(const std::string& folder, int ready);
std::string autosaveFolderOf(const std::string& folder);

}   // namespace angiopose::test
