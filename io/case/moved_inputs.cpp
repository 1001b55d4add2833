#include "io/case/moved_inputs.h"

#include "io/file_hash.h"
#include "io/support/input_bytes.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

constexpr int maxEntries = 5000;   // maximum number of entries to search per folder, including subfolders
constexpr int deepest = 5;
constexpr std::uintmax_t maxHashedBytes = std::uintmax_t{2} << 30U;

std::vector<fs::path> entriesOf(const fs::path& folder)
{
    std::vector<fs::path> entries;
    std::error_code failed;
    fs::recursive_directory_iterator each(folder, fs::directory_options::skip_permission_denied, failed);
    for (; !failed && each != fs::recursive_directory_iterator() && entries.size() < maxEntries;
         each.increment(failed)) {
        if (each.depth() >= deepest) {
            each.disable_recursion_pending();
        }
        entries.push_back(each->path());
    }
    std::ranges::sort(entries, [](const fs::path& a, const fs::path& b) {   // nearest first, in a reproducible order
        const auto depthA = std::distance(a.begin(), a.end());
        const auto depthB = std::distance(b.begin(), b.end());
        return depthA != depthB ? depthA < depthB : a < b;
    });
    return entries;
}

/// Searches one list of directory entries; the bytes hashed for all inputs count toward a common limit.
class Search {
public:
    explicit Search(const ReadObserver& observe) : observe_(observe) {}

    std::string find(const MissingInput& missing, const std::vector<fs::path>& entries)
    {
        const fs::path wanted(missing.path);
        for (const fs::path& entry : entries) {
            if (entry.filename() == wanted.filename() && stands(missing, entry)) {
                return entry.string();
            }
        }
        const std::string extension = extensionOf(missing.path);
        for (const fs::path& entry : entries) {
            std::error_code failed;
            const bool isCandidate = !missing.sha256.empty() && extensionOf(entry.string()) == extension &&
                                     entry.filename() != wanted.filename() && fs::is_regular_file(entry, failed);
            if (isCandidate && stands(missing, entry)) {
                return entry.string();
            }
        }
        return {};
    }

    bool isStopped() const { return isStopped_; }

private:
    bool stands(const MissingInput& missing, const fs::path& entry)
    {
        std::error_code failed;
        const auto size = fs::is_directory(entry, failed) ? 0 : fs::file_size(entry, failed);
        isStopped_ = isStopped_ || isStopRequested(observe_, 0.0);
        if (failed || isStopped_ || hashedBytes_ + size > maxHashedBytes) {
            return false;
        }
        hashedBytes_ += size;
        return canReplace(missing, entry.string());
    }

    const ReadObserver& observe_;
    std::uintmax_t hashedBytes_ = 0;
    bool isStopped_ = false;
};

}   // namespace

bool canReplace(const MissingInput& missing, const std::string& path)
{
    std::error_code failed;
    if (fs::is_directory(path, failed)) {
        return fs::path(missing.path).extension().empty();   // reading it shows whether the folder contains the series
    }
    if (!fs::is_regular_file(path, failed)) {
        return false;
    }
    const auto hash = missing.sha256.empty() ? core::Result<std::string>(std::string()) : sha256OfFile(path);
    return hash && hash.value() == missing.sha256;
}

MovedInputs findMovedInputs(const std::vector<MissingInput>& missing, const std::vector<std::string>& folders,
                            const ReadObserver& observe)
{
    MovedInputs found;
    Search search(observe);
    std::set<fs::path> searched;
    for (const std::string& folder : folders) {
        if (found.size() == missing.size() || search.isStopped()) {
            break;
        }
        std::error_code failed;
        if (!searched.insert(fs::weakly_canonical(folder, failed)).second) {
            continue;
        }
        const std::vector<fs::path> entries = entriesOf(folder);
        for (const MissingInput& each : missing) {
            if (found.contains(each.path)) {
                continue;
            }
            if (std::string place = search.find(each, entries); !place.empty()) {
                found[each.path] = std::move(place);
            }
        }
    }
    return found;
}

}   // namespace angiopose::io
