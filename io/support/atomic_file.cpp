#include "io/support/atomic_file.h"

#include "io/support/file_error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace io {
namespace {

core::Error writeError(const std::string& path)
{
    return fileError(
        path, std::string("it cannot be written (") + std::strerror(errno) + "). Choose another folder or make room.");
}

bool writeAll(int file, std::string_view content)
{
    while (!content.empty()) {
        const ssize_t written = ::write(file, content.data(), content.size());
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written <= 0) {
            return false;
        }
        content.remove_prefix(static_cast<std::size_t>(written));
    }
    return ::fsync(file) == 0;
}

/// Permissions of the file that is replaced, or what a newly created file would get.
mode_t permissionsFor(const std::string& path)
{
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0) {
        return status.st_mode & 07777;
    }
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
}

/// The rename itself must survive a power cut too.
void flushFolder(const std::filesystem::path& folder)
{
    const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle >= 0) {
        ::fsync(handle);
        ::close(handle);
    }
}

}   // namespace

core::Status writeAtomically(const std::string& path, std::string_view content)
{
    std::error_code unresolved;
    // Through a link: the file it points to is replaced, not the link.
    const std::filesystem::path target = std::filesystem::weakly_canonical(path, unresolved);
    if (unresolved || std::filesystem::is_directory(target, unresolved)) {
        return fileError(path, "this is not a place for a file. Give a file name in an existing folder.");
    }
    std::string temporary = (target.parent_path() / ("." + target.filename().string() + ".XXXXXX")).string();
    const int file = ::mkstemp(temporary.data());
    if (file < 0) {
        return writeError(path);
    }
    const bool written = writeAll(file, content) && ::fchmod(file, permissionsFor(target.string())) == 0;
    const bool closed = ::close(file) == 0;
    if (!written || !closed || ::rename(temporary.c_str(), target.c_str()) != 0) {
        const core::Error error = writeError(path);
        ::unlink(temporary.c_str());
        return error;
    }
    flushFolder(target.parent_path());
    return core::Done{};
}

}   // namespace io
