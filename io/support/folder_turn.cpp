#include "io/support/folder_turn.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <cerrno>
#include <chrono>
#include <thread>

namespace angiopose::io {
namespace {

constexpr auto longestTurnWait = std::chrono::seconds(2);

}   // namespace

FolderTurn::FolderTurn(const std::string& folder) : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
    const auto end = std::chrono::steady_clock::now() + longestTurnWait;
    while (folder_ >= 0 && ::flock(folder_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK &&
           std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

FolderTurn::~FolderTurn()
{
    if (folder_ >= 0) {
        ::close(folder_);
    }
}

}   // namespace angiopose::io
