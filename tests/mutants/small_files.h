#pragma once

#include "tests/support/temporary_folder.h"

#include <string>
#include <vector>

namespace angiopose::test {

struct SmallFile {
    std::string name;   ///< with the extension expected by its reader
    std::string content;
    bool isGzip = false;   ///< `content` is to be stored in a gzip archive
    bool isSurface = false;
    bool isDisc = false;   ///< a DICOMDIR, whose files are in `scratch` next to it
};

/// One small file of every format that is read. `dataFolder`: real files of formats without a writer here; those
/// formats are left out if the folder is missing. `scratch`: a folder to write to.
std::vector<SmallFile> smallFiles(const std::string& dataFolder, const TemporaryFolder& scratch);

}   // namespace angiopose::test
