#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Pattern for mkstemp of a hidden temporary file beside `target`. It tells whose it is: this machine's and this
/// process's.
std::string temporaryPatternFor(const std::string& target);

/// Removes temporary files and locks (case_lock.h) that processes of this machine left in `folder` when they were
/// killed. Files of living processes, of other machines and of other programs stay. How many went.
int removeLeftovers(const std::string& folder);

/// The same, once for every folder that this process writes to.
void removeLeftoversOnce(const std::string& folder);

/// Who a lock names.
struct LockHolder {
    int process = 0;
    std::string machine;
};

/// What a lock of this process holds, and what a lock says; nothing where it is none, or is being written.
std::string lockText();
std::optional<LockHolder> parseLock(std::string_view text);

/// The lock of a case file, hidden beside it.
std::string lockPathOf(const std::string& casePath);

}   // namespace angiopose::io
