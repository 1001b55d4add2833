#include "io/support/files_in_folder.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <filesystem>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxFilesInFolder = 50'000;
constexpr int deepestFolder = 8;

}   // namespace

core::Result<std::vector<std::string>> filesInFolder(const std::string& folder, FolderDepth folderDepth)
{
    std::vector<std::string> files;
    std::error_code failed;
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, failed);
    if (failed) {
        return fileError(folder, messages::folderNotRead(failed.message()));
    }
    for (; at != fs::recursive_directory_iterator(); at.increment(failed)) {
        if (failed || files.size() > maxFilesInFolder) {
            return fileError(folder, failed ? messages::folderNotReadToEnd() : messages::folderTooFull());
        }
        if (folderDepth == FolderDepth::TopLevel || at.depth() >= deepestFolder) {
            at.disable_recursion_pending();
        }
        std::error_code unknown;
        if (at->is_regular_file(unknown) && at->path().filename() != "DICOMDIR") {
            files.push_back(at->path().string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

}   // namespace angiopose::io
