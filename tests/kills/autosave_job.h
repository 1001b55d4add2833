#pragma once

#include <string>

namespace angiopose::test {

/// Has a session keep automatic copies of the case in `folder` until it is killed; they lie in `dataFolderOf(folder)`.
int autosaveForEver(const std::string& folder, int ready);
std::string autosaveFolderOf(const std::string& folder);

}   // namespace angiopose::test
