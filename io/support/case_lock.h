#pragma once

#include "io/support/own_leftovers.h"
#include "io/support/system/held_file.h"

#include <optional>
#include <string>

namespace angiopose::io {

/// Says to other programs that a case is open: a hidden file beside it (FORMATS §2) that the system frees when the
/// program ends, however it ends. It keeps nobody from anything.
class CaseLock {
public:
    CaseLock() = default;
    /// Holds nothing where somebody else has the case open, or the folder cannot be written.
    explicit CaseLock(const std::string& casePath);
    CaseLock(CaseLock&& other) noexcept;
    CaseLock& operator=(CaseLock&& other) noexcept;
    ~CaseLock();

    bool isHeld() const { return file_.isOpen(); }

private:
    std::string path_;
    HeldFile file_;
};

/// Who else has a case open: another program, or another `CaseLock` of this one. Nobody where a lock is stale.
std::optional<LockHolder> holderOf(const std::string& casePath);

/// While it lives no other `FolderTurn` of the folder does, in this program or another: waits for it, two seconds at
/// most. Without effect where the file system knows no such locks.
class FolderTurn {
public:
    explicit FolderTurn(const std::string& folder);

private:
    HeldFile folder_;
};

}   // namespace angiopose::io
