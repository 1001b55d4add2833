#include "io/support/system/files.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>

namespace angiopose::io {

FileStatus fileStatus(const std::string& path)
{
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        return errno == ENOENT ? FileStatus{} : FileStatus{FileKind::Unreachable, 0, std::strerror(errno)};
    }
    const FileKind kind = S_ISDIR(status.st_mode)   ? FileKind::Folder
                          : S_ISREG(status.st_mode) ? FileKind::Regular
                                                    : FileKind::Other;
    return {kind, static_cast<std::size_t>(status.st_size), {}};
}

ReadHandle::ReadHandle(const std::string& path) : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK))
{
    struct stat status {};
    if (descriptor_ < 0) {
        problem_ = std::strerror(errno);
    } else if (::fstat(descriptor_, &status) != 0) {
        problem_ = std::strerror(errno);
        ::close(descriptor_);
        descriptor_ = -1;
    } else {
        isRegular_ = S_ISREG(status.st_mode);
        size_ = static_cast<std::size_t>(status.st_size);
    }
}

ReadHandle::~ReadHandle()
{
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

std::size_t ReadHandle::read(char* bytes, std::size_t maxBytes)
{
    ssize_t got = -1;
    do {
        got = ::read(descriptor_, bytes, maxBytes);
    } while (got < 0 && errno == EINTR);
    if (got <= 0) {
        problem_ = std::strerror(got < 0 ? errno : EIO);
    }
    return got > 0 ? static_cast<std::size_t>(got) : 0;
}

const char* ReadHandle::map()
{
    void* const mapping = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor_, 0);
    if (mapping == MAP_FAILED) {
        problem_ = std::strerror(errno);
        return nullptr;
    }
    return static_cast<const char*>(mapping);
}

void unmap(const char* mapping, std::size_t size)
{
    ::munmap(const_cast<char*>(mapping), size);
}

std::optional<std::string> findMappingFault(const char* mapping, std::size_t size)
{
    while (::madvise(const_cast<char*>(mapping), size, MADV_POPULATE_READ) != 0) {
        if (errno == EINVAL || errno == ENOSYS) {
            return std::nullopt;
        }
        if (errno != EINTR && errno != EAGAIN) {   // EFAULT means that accessing the bytes would raise SIGBUS
            return std::strerror(errno == EFAULT ? EIO : errno);
        }
    }
    return std::nullopt;
}

}   // namespace angiopose::io
