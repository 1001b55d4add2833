#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns the mkstemp pattern of a hidden temporary file next to `target`; it identifies this machine and this
/// process.
std::string temporaryPatternFor(const std::string& target);

/// Removes temporary files and locks (case_lock.h) that killed processes of this machine left in `folder`. Keeps files
/// of running processes, other machines and other programs. Returns how many it removed.
int removeLeftovers(const std::string& folder);

/// Removes such leftovers once for every folder that this process writes to.
void removeLeftoversOnce(const std::string& folder);

/// The holder that a lock names.
struct LockHolder {
    int process = 0;
    std::string machine;
};

/// Writes and parses the content of a lock: `lockText` for this process, `parseLock` for any; nullopt if it is not a
/// lock, or is still being written.
std::string lockText();
std::optional<LockHolder> parseLock(std::string_view text);

/// Returns the path of a case file's lock, hidden next to it.
std::string lockPathOf(const std::string& casePath);

}   // namespace angiopose::io
