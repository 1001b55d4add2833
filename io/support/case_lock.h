#pragma once

#include "io/support/own_leftovers.h"
#include "io/support/system/held_file.h"

#include <optional>
#include <string>

namespace angiopose::io {

/// Marks a case as open for other programs: a hidden file next to it (FORMATS §2), released by the system however the
/// program ends. The lock is advisory and blocks nobody.
class CaseLock {
public:
    CaseLock() = default;
    /// Holds nothing if another program has the case open, or the folder is not writable.
    explicit CaseLock(const std::string& casePath);
    CaseLock(CaseLock&& other) noexcept;
    CaseLock& operator=(CaseLock&& other) noexcept;
    ~CaseLock();

    bool isHeld() const { return file_.isOpen(); }

private:
    std::string path_;
    HeldFile file_;
};

/// Returns who else has a case open: another program, or another `CaseLock` of this one. Ignores stale locks.
std::optional<LockHolder> holderOf(const std::string& casePath);

/// Exclusive access to a folder, across programs: the constructor waits for its turn, at most two seconds. Has no
/// effect if the file system does not support such locks.
class FolderTurn {
public:
    explicit FolderTurn(const std::string& folder);

private:
    HeldFile folder_;
};

}   // namespace angiopose::io
