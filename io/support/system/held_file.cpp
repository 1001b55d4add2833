#include "io/support/system/held_file.h"

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

int flagsFor(HeldFile::Way way)
{
    switch (way) {
        case HeldFile::Way::Read:
            return O_RDONLY | O_NOFOLLOW;
        case HeldFile::Way::Write:
            return O_RDWR | O_CREAT | O_NOFOLLOW;
        case HeldFile::Way::Folder:
            break;
    }
    return O_RDONLY | O_DIRECTORY;
}

HeldFile::Held heldBy(int file, int how)
{
    if (::flock(file, how | LOCK_NB) == 0) {
        return HeldFile::Held::Mine;
    }
    return errno == EWOULDBLOCK ? HeldFile::Held::ByAnother : HeldFile::Held::Impossible;
}

}   // namespace

HeldFile::HeldFile(const std::string& path, Way way) : value_(::open(path.c_str(), flagsFor(way) | O_CLOEXEC, 0666)) {}

HeldFile::HeldFile(HeldFile&& other) noexcept : value_(std::exchange(other.value_, -1)) {}

HeldFile& HeldFile::operator=(HeldFile&& other) noexcept
{
    std::swap(value_, other.value_);
    return *this;
}

HeldFile::~HeldFile()
{
    close();
}

void HeldFile::close()
{
    if (value_ >= 0) {
        ::close(std::exchange(value_, -1));
    }
}

HeldFile::Held HeldFile::holdAlone() const
{
    return heldBy(value_, LOCK_EX);
}

HeldFile::Held HeldFile::holdWithOthers() const
{
    return heldBy(value_, LOCK_SH);
}

bool HeldFile::isStillAt(const std::string& path) const
{
    struct stat opened {};
    struct stat there {};
    return ::fstat(value_, &opened) == 0 && ::stat(path.c_str(), &there) == 0 && opened.st_ino == there.st_ino &&
           opened.st_dev == there.st_dev;
}

std::string HeldFile::text() const
{
    std::array<char, 512> bytes{};
    const ssize_t size = ::pread(value_, bytes.data(), bytes.size(), 0);
    return {bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
}

void HeldFile::setText(const std::string& text) const
{
    if (::ftruncate(value_, 0) == 0) {
        [[maybe_unused]] const ssize_t written = ::pwrite(value_, text.data(), text.size(), 0);
    }
}

}   // namespace angiopose::io
