#include "io/support/case_lock.h"

#include "io/support/system/own_process.h"

#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

namespace angiopose::io {
namespace {

constexpr auto longestTurnWait = std::chrono::seconds(2);

}   // namespace

CaseLock::CaseLock(const std::string& casePath) : path_(lockPathOf(casePath))
{
    constexpr int tries = 3;   // an attempt fails only if another program removes its lock at that moment
    for (int i = 0; i < tries && !file_.isOpen(); ++i) {
        HeldFile file(path_, HeldFile::Way::Write);
        if (!file.isOpen() || file.holdAlone() != HeldFile::Held::Mine) {
            return;
        }
        if (file.isStillAt(path_)) {
            file.setText(lockText());   // the file remains empty if the drive is full
            file_ = std::move(file);
        }
    }
}

CaseLock::CaseLock(CaseLock&& other) noexcept : path_(std::move(other.path_)), file_(std::move(other.file_)) {}

CaseLock& CaseLock::operator=(CaseLock&& other) noexcept
{
    std::swap(path_, other.path_);
    std::swap(file_, other.file_);
    return *this;
}

CaseLock::~CaseLock()
{
    if (file_.isOpen()) {
        std::error_code ignored;
        std::filesystem::remove(
            path_, ignored);   // removed while still locked, so that no other process locks a deleted file
    }
}

std::optional<LockHolder> holderOf(const std::string& casePath)
{
    const HeldFile file(lockPathOf(casePath), HeldFile::Way::Read);
    if (!file.isOpen() || file.holdWithOthers() != HeldFile::Held::ByAnother) {
        return std::nullopt;
    }
    const std::optional<LockHolder> holder = parseLock(file.text());
    return holder ? holder : LockHolder{0, machineName()};
}

FolderTurn::FolderTurn(const std::string& folder) : folder_(folder, HeldFile::Way::Folder)
{
    const auto end = std::chrono::steady_clock::now() + longestTurnWait;
    while (folder_.isOpen() && folder_.holdAlone() == HeldFile::Held::ByAnother &&
           std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

}   // namespace angiopose::io
