#include "io/support/system/lockable_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace angiopose::io {
namespace {

int flagsFor(LockableFile::OpenMode mode)
{
    switch (mode) {
        case LockableFile::OpenMode::Read:
            return O_RDONLY | O_NOFOLLOW;
        case LockableFile::OpenMode::Write:
            return O_RDWR | O_CREAT | O_NOFOLLOW;
        case LockableFile::OpenMode::Folder:
            break;
    }
    return O_RDONLY | O_DIRECTORY;
}

LockableFile::LockState tryLock(int file, int how)
{
    if (::flock(file, how | LOCK_NB) == 0) {
        return LockableFile::LockState::Acquired;
    }
    return errno == EWOULDBLOCK ? LockableFile::LockState::HeldByOther : LockableFile::LockState::Impossible;
}

}   // namespace

LockableFile::LockableFile(const std::string& path, OpenMode mode)
    : descriptor_(::open(path.c_str(), flagsFor(mode) | O_CLOEXEC, 0666))
{
}

LockableFile::LockableFile(LockableFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

LockableFile& LockableFile::operator=(LockableFile&& other) noexcept
{
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

LockableFile::~LockableFile()
{
    close();
}

void LockableFile::close()
{
    if (descriptor_ >= 0) {
        ::close(std::exchange(descriptor_, -1));
    }
}

LockableFile::LockState LockableFile::lockExclusive() const
{
    return tryLock(descriptor_, LOCK_EX);
}

LockableFile::LockState LockableFile::lockShared() const
{
    return tryLock(descriptor_, LOCK_SH);
}

bool LockableFile::isStillLinkedAt(const std::string& path) const
{
    struct stat opened {};
    struct stat there {};
    return ::fstat(descriptor_, &opened) == 0 && ::stat(path.c_str(), &there) == 0 && opened.st_ino == there.st_ino &&
           opened.st_dev == there.st_dev;
}

std::string LockableFile::text() const
{
    std::array<char, 512> bytes{};
    const ssize_t size = ::pread(descriptor_, bytes.data(), bytes.size(), 0);
    return {bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
}

void LockableFile::setText(const std::string& text) const
{
    if (::ftruncate(descriptor_, 0) == 0) {
        [[maybe_unused]] const ssize_t written = ::pwrite(descriptor_, text.data(), text.size(), 0);
    }
}

}   // namespace angiopose::io
