#include "io/support/atomic_file.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/own_leftovers.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

namespace angiopose::io {
namespace {

core::Error writeError(const std::string& path)
{
    return fileError(path,
                     errno == EFBIG ? messages::fileBeyondLimit() : messages::fileNotWritten(std::strerror(errno)));
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
    return true;
}

/// Returns the permissions of the file to replace, or the default permissions if there is no such file.
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

/// Flushes the folder, so that the rename itself also survives a power failure.
void flushFolder(const std::filesystem::path& folder)
{
    const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle >= 0) {
        ::fsync(handle);
        ::close(handle);
    }
}

}   // namespace

AtomicFile::AtomicFile(std::string path, std::string target, std::string temporary, int file)
    : path_(std::move(path)), target_(std::move(target)), temporary_(std::move(temporary)), file_(file)
{
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::move(other.temporary_)),
      file_(std::exchange(other.file_, -1))
{
}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept
{
    std::swap(path_, other.path_);
    std::swap(target_, other.target_);
    std::swap(temporary_, other.temporary_);
    std::swap(file_, other.file_);
    return *this;
}

AtomicFile::~AtomicFile()
{
    if (file_ >= 0) {
        ::close(file_);
        ::unlink(temporary_.c_str());
    }
}

core::Result<AtomicFile> AtomicFile::create(const std::string& path)
{
    std::error_code unresolved;
    // Resolve symbolic links: replace the file to which a link points, not the link.
    const std::filesystem::path target = std::filesystem::weakly_canonical(path, unresolved);
    if (unresolved || std::filesystem::is_directory(target, unresolved)) {
        return fileError(path, messages::fileNoPlace());
    }
    removeLeftoversOnce(target.parent_path().string());
    std::string temporary = temporaryPatternFor(target.string());
    const int file = ::mkostemp(temporary.data(), O_CLOEXEC);
    if (file < 0) {
        return writeError(path);
    }
    ::flock(file, LOCK_EX | LOCK_NB);   // locked, so that other processes do not remove the file as a leftover
    return AtomicFile(path, target.string(), std::move(temporary), file);
}

core::Status AtomicFile::write(std::string_view content)
{
    return writeAll(file_, content) ? core::Status(core::Done{}) : writeError(path_);
}

core::Status AtomicFile::commit()
{
    const int file = std::exchange(file_, -1);
    const bool written = ::fsync(file) == 0 && ::fchmod(file, permissionsFor(target_)) == 0;
    const bool closed = ::close(file) == 0;
    if (!written || !closed || ::rename(temporary_.c_str(), target_.c_str()) != 0) {
        const core::Error error = writeError(path_);
        ::unlink(temporary_.c_str());
        return error;
    }
    flushFolder(std::filesystem::path(target_).parent_path());
    return core::Done{};
}

core::Status writeAtomically(const std::string& path, std::string_view content)
{
    auto created = AtomicFile::create(path);
    if (!created) {
        return created.error();
    }
    AtomicFile file = std::move(created).value();
    if (auto written = file.write(content); !written) {
        return written;
    }
    return file.commit();
}

}   // namespace angiopose::io
