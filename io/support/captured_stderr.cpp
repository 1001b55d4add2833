#include "io/support/captured_stderr.h"

#include <unistd.h>

namespace angiopose::io {
namespace {

constexpr std::size_t mostKept = 4096;

std::mutex& turns()
{
    static std::mutex mutex;
    return mutex;
}

}   // namespace

CapturedStderr::CapturedStderr() : turn_(turns()), kept_(std::tmpfile())
{
    std::fflush(stderr);
    stderr_ = kept_ ? dup(STDERR_FILENO) : -1;
    if (stderr_ >= 0) {
        dup2(fileno(kept_), STDERR_FILENO);
    }
}

CapturedStderr::~CapturedStderr()
{
    if (stderr_ >= 0) {
        std::fflush(stderr);
        dup2(stderr_, STDERR_FILENO);
        close(stderr_);
    }
    if (kept_) {
        std::fclose(kept_);
    }
}

std::string CapturedStderr::text()
{
    std::string text(mostKept, '\0');
    std::fflush(stderr);
    const ssize_t read = stderr_ >= 0 ? pread(fileno(kept_), text.data(), text.size(), 0) : 0;
    text.resize(read > 0 ? static_cast<std::size_t>(read) : 0);
    return text;
}

}   // namespace angiopose::io