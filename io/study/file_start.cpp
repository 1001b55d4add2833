#include "io/study/file_start.h"

#include "io/messages/says.h"
#include "io/support/file_error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstring>

namespace angiopose::io {
namespace {

constexpr std::size_t blockSize = std::size_t{1} << 20;

class ReadHandle {
public:
    explicit ReadHandle(const std::string& path) : value_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
    ReadHandle(const ReadHandle&) = delete;
    ReadHandle& operator=(const ReadHandle&) = delete;
    ~ReadHandle()
    {
        if (value_ >= 0) {
            ::close(value_);
        }
    }
    int value() const { return value_; }

private:
    int value_;
};

}   // namespace

core::Result<FileStart> readStart(const std::string& path, std::size_t size, const ReadObserver& observe)
{
    const ReadHandle file(path);
    struct stat status {};
    if (file.value() < 0 || ::fstat(file.value(), &status) != 0) {
        return fileError(path, says::fileNotOpened(std::strerror(errno)));
    }
    if (!S_ISREG(status.st_mode)) {
        return fileError(path, says::fileNotRegular());
    }
    if (status.st_size == 0) {
        return fileError(path, says::fileEmpty());
    }
    FileStart start;
    start.fileSize = static_cast<std::size_t>(status.st_size);
    const std::size_t wanted = std::min(size, start.fileSize);
    start.bytes.resize(wanted);
    for (std::size_t at = 0; at < wanted;) {
        if (isStopWished(observe, static_cast<double>(at) / static_cast<double>(wanted))) {
            return stoppedReading(path);
        }
        const ssize_t got = ::read(file.value(), start.bytes.data() + at, std::min(blockSize, wanted - at));
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got <= 0) {
            return fileError(path, says::fileNotRead(got < 0 ? std::strerror(errno) : std::strerror(EIO)));
        }
        at += static_cast<std::size_t>(got);
    }
    return start;
}

}   // namespace angiopose::io
