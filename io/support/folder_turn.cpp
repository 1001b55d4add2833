#include "io/support/folder_turn.h"

#include <chrono>
#include <thread>

namespace angiopose::io {
namespace {

constexpr auto longestTurnWait = std::chrono::seconds(2);

}   // namespace

FolderTurn::FolderTurn(const std::string& folder) : folder_(folder, HeldFile::Way::Folder)
{
    const auto end = std::chrono::steady_clock::now() + longestTurnWait;
    while (folder_.isOpen() && folder_.holdAlone() == HeldFile::Held::ByAnother &&
           std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

}   // namespace angiopose::io
