#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns the mkstemp pattern of a hidden temporary file next to `target`; the name identifies this computer and this
/// process.
std::string temporaryPatternFor(const std::string& target);

/// Removes temporary files and locks (case_lock.h) that killed processes of this computer left in `folder`. Keeps files
/// of running processes, other computers and other programs. Returns the number of removed files.
int removeLeftovers(const std::string& folder);

/// Calls removeLeftovers once for each folder to which this process writes.
void removeLeftoversOnce(const std::string& folder);

/// Process that holds a lock, as named in the lock file.
struct LockHolder {
    int process = 0;
    std::string machine;
};

/// `lockText` returns the text of a lock file for this process; `parseLock` parses the text of any lock file and
/// returns nullopt if that is not a lock or is still being written.
std::string lockText();
std::optional<LockHolder> parseLock(std::string_view text);

/// Returns the path of the hidden lock file next to a case file.
std::string lockPathOf(const std::string& casePath);

}   // namespace angiopose::io
