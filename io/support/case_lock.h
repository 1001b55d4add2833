#pragma once

#include "io/support/own_leftovers.h"
#include "io/support/system/lockable_file.h"

#include <optional>
#include <string>

namespace angiopose::io {

/// Shows other programs that a case is open, by locking a hidden file next to the case (FORMATS §2). The operating
/// system releases the lock however the program ends. The lock is advisory and does not prevent access.
class CaseLock {
public:
    CaseLock() = default;
    /// Acquires the lock unless another program has the case open or the folder is not writable.
    explicit CaseLock(const std::string& casePath);
    CaseLock(CaseLock&& other) noexcept;
    CaseLock& operator=(CaseLock&& other) noexcept;
    ~CaseLock();

    bool isHeld() const { return file_.isOpen(); }

private:
    std::string path_;
    LockableFile file_;
};

/// Returns who else has a case open: another program, or another `CaseLock` in this process. Ignores stale locks.
std::optional<LockHolder> lockHolderOf(const std::string& casePath);

/// Exclusive access to a folder across programs. The constructor waits for other programs for at most two seconds. Has
/// no effect if the file system does not support locks.
class FolderLock {
public:
    explicit FolderLock(const std::string& folder);

private:
    LockableFile folder_;
};

}   // namespace angiopose::io
