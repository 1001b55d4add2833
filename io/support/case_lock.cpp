#include "io/support/case_lock.h"

#include "io/support/system/current_process.h"

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
    constexpr int tries = 3;   // an attempt fails only if another program is just removing its lock
    for (int i = 0; i < tries && !file_.isOpen(); ++i) {
        LockableFile file(path_, LockableFile::OpenMode::Write);
        if (!file.isOpen() || file.lockExclusive() != LockableFile::LockState::Acquired) {
            return;
        }
        if (file.isStillLinkedAt(path_)) {
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
        std::filesystem::remove(path_,
                                ignored);   // removed while still locked, so that no other process locks a deleted file
    }
}

std::optional<LockHolder> lockHolderOf(const std::string& casePath)
{
    const LockableFile file(lockPathOf(casePath), LockableFile::OpenMode::Read);
    if (!file.isOpen() || file.lockShared() != LockableFile::LockState::HeldByOther) {
        return std::nullopt;
    }
    const std::optional<LockHolder> holder = parseLock(file.text());
    return holder ? holder : LockHolder{0, hostName()};
}

FolderLock::FolderLock(const std::string& folder) : folder_(folder, LockableFile::OpenMode::Folder)
{
    const auto end = std::chrono::steady_clock::now() + longestTurnWait;
    while (folder_.isOpen() && folder_.lockExclusive() == LockableFile::LockState::HeldByOther &&
           std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

}   // namespace angiopose::io
