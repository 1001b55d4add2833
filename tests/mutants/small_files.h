#pragma once

#include "tests/support/temporary_folder.h"

#include <string>
#include <vector>

namespace angiopose::test {

/// A small sound file of one format.
struct SmallFile {
    std::string name;   ///< with the extension that its reader expects
    std::string content;
    bool isGzip = false;   ///< `content` is what belongs inside an archive
    bool isSurface = false;
    bool isDisc = false;   ///< the directory of a disc, whose files lie in `scratch` beside it
};

/// One small file of every format that is read. `dataFolder`: real files of formats that nothing here writes; those
/// formats are left out where it is absent. `scratch`: a folder to write to.
std::vector<SmallFile> smallFiles(const std::string& dataFolder, const TemporaryFolder& scratch);

}   // namespace angiopose::test
