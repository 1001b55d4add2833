#include "io/case/case_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <utility>

namespace angiopose::io {
namespace {

/// Whether the open file is still the one that the path leads to: another program may just have removed it.
bool isStillAt(int file, const std::string& path)
{
    struct stat opened {};
    struct stat there {};
    return ::fstat(file, &opened) == 0 && ::stat(path.c_str(), &there) == 0 && opened.st_ino == there.st_ino &&
           opened.st_dev == there.st_dev;
}

bool saysWho(int file)
{
    const std::string text = lockText();
    return ::ftruncate(file, 0) == 0 &&
           ::pwrite(file, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
}

}   // namespace

CaseLock::CaseLock(const std::string& casePath) : path_(lockPathOf(casePath))
{
    constexpr int tries = 3;   // each is lost only where another program removes its lock at that moment
    for (int i = 0; i < tries && file_ < 0; ++i) {
        const int file = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (file < 0) {
            return;
        }
        if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
            ::close(file);
            return;
        }
        if (isStillAt(file, path_)) {
            saysWho(file);   // on a full drive it stays without a name
            file_ = file;
        } else {
            ::close(file);
        }
    }
}

CaseLock::CaseLock(CaseLock&& other) noexcept : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

CaseLock& CaseLock::operator=(CaseLock&& other) noexcept
{
    std::swap(path_, other.path_);
    std::swap(file_, other.file_);
    return *this;
}

CaseLock::~CaseLock()
{
    if (file_ >= 0) {
        ::unlink(path_.c_str());   // while it is held: nobody takes over what goes
        ::close(file_);
    }
}

std::optional<LockHolder> holderOf(const std::string& casePath)
{
    const int file = ::open(lockPathOf(casePath).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (file < 0) {
        return std::nullopt;
    }
    std::optional<LockHolder> holder;
    if (::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        std::array<char, 512> text{};
        const ssize_t size = ::pread(file, text.data(), text.size(), 0);
        holder = parseLock({text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))});
        holder = holder ? holder : LockHolder{0, machineName()};
    }
    ::close(file);
    return holder;
}

}   // namespace angiopose::io
