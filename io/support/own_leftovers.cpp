#include "io/support/own_leftovers.h"

#include "io/support/numbers.h"
#include "io/support/system/current_process.h"
#include "io/support/system/lockable_file.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <set>
#include <vector>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view temporaryMark = ".angiopose-";
constexpr std::string_view lockEnding = ".angiopose-lock";
constexpr std::size_t maxStemBytes = 180;   // bytes; a file name may have 255

/// Returns eight digits that distinguish computers sharing a folder.
std::string hostTag()
{
    std::uint32_t hash = 2166136261U;   // FNV-1a hash
    for (const char letter : hostName()) {
        hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619U;
    }
    std::array<char, 16> digits;
    std::snprintf(digits.data(), digits.size(), "%08x", hash);
    return digits.data();
}

bool isLockName(const fs::path& path)
{
    const std::string name = path.filename().string();
    return name.starts_with('.') && name.ends_with(lockEnding);
}

/// Returns the ID of the process on this computer that created a temporary file; 0 if it was created in another way.
int creatorProcess(std::string_view name, std::string_view tag)
{
    const std::size_t at = name.rfind(temporaryMark);
    if (!name.starts_with('.') || at == std::string_view::npos || at == 0) {
        return 0;
    }
    name.remove_prefix(at + temporaryMark.size());   // the rest of the name has the format tag-process-XXXXXX
    constexpr std::size_t randomLetters = 6;
    if (!name.starts_with(tag) || name.size() < tag.size() + randomLetters + 3 || name[tag.size()] != '-' ||
        name[name.size() - randomLetters - 1] != '-') {
        return 0;
    }
    const auto process = parseInteger(name.substr(tag.size() + 1, name.size() - tag.size() - randomLetters - 2));
    return process && *process > 0 ? *process : 0;
}

/// Returns whether a lock file names a process of this computer that is no longer running.
bool isStaleLock(const LockableFile& lockFile)
{
    const auto holder = parseLock(lockFile.text());
    return holder && holder->machine == hostName() && !isProcessRunning(holder->process);
}

/// Removes a leftover file that no process has locked; returns whether the file was removed.
bool removeIfUnlocked(const fs::path& path)
{
    const LockableFile file(path.string(), LockableFile::OpenMode::Read);
    const bool isUnheld = file.isOpen() && file.lockExclusive() == LockableFile::LockState::Acquired &&
                          (!isLockName(path) || isStaleLock(file));
    std::error_code failed;
    return isUnheld && fs::remove(path, failed);
}

}   // namespace

std::string lockText()
{
    return std::to_string(currentProcessId()) + "\n" + hostName() + "\n";
}

std::optional<LockHolder> parseLock(std::string_view text)
{
    const std::size_t first = text.find('\n');
    const std::size_t second = first == std::string_view::npos ? first : text.find('\n', first + 1);
    const auto process = second == std::string_view::npos ? std::nullopt : parseInteger(text.substr(0, first));
    return process && *process > 0
               ? std::optional(LockHolder{*process, std::string(text.substr(first + 1, second - first - 1))})
               : std::nullopt;
}

std::string temporaryPatternFor(const std::string& target)
{
    const fs::path path(target);
    const std::string stem = path.filename().string().substr(0, maxStemBytes);
    return (path.parent_path() / ("." + stem + std::string(temporaryMark) + hostTag() + "-" +
                                  std::to_string(currentProcessId()) + "-XXXXXX"))
        .string();
}

std::string lockPathOf(const std::string& casePath)
{
    std::error_code unresolved;
    fs::path path = fs::weakly_canonical(casePath, unresolved);   // links to the same case share one lock
    path = unresolved ? fs::path(casePath) : path;
    return (path.parent_path() / ("." + path.filename().string() + std::string(lockEnding))).string();
}

int removeLeftovers(const std::string& folder)
{
    const std::string tag = hostTag();
    std::vector<fs::path> leftovers;
    std::error_code failed;
    for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
        const std::string name = at->path().filename().string();
        const int maker = creatorProcess(name, tag);
        if (isLockName(at->path()) || (maker != 0 && !isProcessRunning(maker))) {
            leftovers.push_back(at->path());
        }
    }
    int gone = 0;
    for (const fs::path& path : leftovers) {
        gone += removeIfUnlocked(path) ? 1 : 0;
    }
    return gone;
}

void removeLeftoversOnce(const std::string& folder)
{
    static std::mutex mutex;
    static std::set<std::string> done;
    {
        const std::scoped_lock lock(mutex);
        if (!done.insert(folder).second) {
            return;
        }
    }
    removeLeftovers(folder);
}

}   // namespace angiopose::io
