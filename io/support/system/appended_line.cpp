#include "io/support/system/appended_line.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

namespace angiopose::io {
namespace {

using namespace std::chrono_literals;

constexpr int lockTries = 200;   // 2 s in total; other programs hold the lock only while writing a line

bool isLocked(int file)
{
    for (int i = 0; i < lockTries; ++i) {
        if (::flock(file, LOCK_EX | LOCK_NB) == 0) {
            return true;
        }
        if (errno != EWOULDBLOCK) {
            return true;   // the drive does not support locks: rely on O_APPEND
        }
        std::this_thread::sleep_for(10ms);
    }
    return false;
}

std::string append(int file, const std::string& text)
{
    if (!isLocked(file)) {
        return "another program has locked it";
    }
    const off_t end = ::lseek(file, 0, SEEK_END);
    const ssize_t written = ::write(file, text.data(), text.size());
    const int failure = errno;
    if (written == static_cast<ssize_t>(text.size())) {
        return ::fsync(file) == 0 || errno == EINVAL || errno == EROFS ? std::string() : std::strerror(errno);
    }

    if (written > 0 && ::ftruncate(file, end) != 0) {
        return "it ends with an incomplete line";
    }
    return std::strerror(written < 0 ? failure : ENOSPC);
}

}   // namespace

std::string appendLine(const std::string& path, std::string_view line)
{
    const int file = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0600);
    if (file < 0) {
        return std::strerror(errno);
    }
    struct stat status {};
    const bool isRegular = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
    const std::string problem = isRegular ? append(file, std::string(line) + '\n') : "it is not a regular file";
    ::close(file);   // also releases the lock
    return problem;
}

}   // namespace angiopose::io
