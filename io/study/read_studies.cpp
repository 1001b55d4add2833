#include "io/study/read_studies.h"

#include "io/messages/messages.h"
#include "io/study/dicom_directory.h"
#include "io/study/study_collector.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <set>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t maxFiles = 50'000;
constexpr int maxFolderDepth = 12;
constexpr auto listedEvery = std::chrono::milliseconds(300);
constexpr int groupingShare = 10;   ///< minimum interval between regroupings, as a multiple of the time that one takes

/// Returns whether a file may be an image; false for the viewers and web pages that discs also contain.
bool mayBeImage(const std::string& path)
{
    static constexpr std::array<std::string_view, 24> others{
        ".exe", ".dll", ".htm", ".html", ".txt", ".pdf", ".inf", ".ico", ".jar", ".xml", ".css", ".js",
        ".png", ".jpg", ".gif", ".bmp",  ".ini", ".zip", ".log", ".bat", ".sh",  ".so",  ".dat", ".cab"};
    return std::ranges::find(others, extensionOf(path)) == others.end();
}

/// Scan of a folder: the files found, the headers read, and the progress reported.
class Scan {
public:
    explicit Scan(const StudyObserver& observe) : observe_(observe) {}

    /// Adds the files of a folder.
    core::Status find(const std::string& folder)
    {
        std::error_code failed;
        if (fs::directory_iterator(folder, failed); failed) {
            return fileError(folder, messages::folderNotRead(failed.message()));
        }
        walk(folder, 0);
        std::ranges::sort(files_);
        return core::Done{};
    }

    /// Collects the files of a folder and its subfolders. Reports folders that cannot be read (scratched disc) and
    /// continues with the others.
    void walk(const fs::path& folder, int depth)
    {
        std::error_code failed;
        fs::directory_iterator at(folder, fs::directory_options::skip_permission_denied, failed);
        for (; !failed && at != fs::directory_iterator() && !isFinished_; at.increment(failed)) {
            std::error_code unknown;
            if (at->is_directory(unknown) && !at->is_symlink(unknown)) {
                if (depth < maxFolderDepth) {
                    walk(at->path(), depth + 1);
                }
            } else if (at->is_regular_file(unknown)) {
                note(at->path().string());
            }
        }
        if (failed) {
            tree_.damagedFiles.push_back({folder.string(), messages::folderNotReadToEnd()});
        }
    }

    void note(const std::string& path)
    {
        if (files_.size() >= maxFiles) {
            tree_.isTruncated = true;
            isFinished_ = true;
            return;
        }
        files_.push_back(path);
        tree_.foundFiles = files_.size();
        isFinished_ = files_.size() % 64 == 0 && isStopped();
    }

    /// Keeps only files that the DICOMDIR lists, and records files that are missing or not listed.
    void keepListed(const std::string& directoryPath)
    {
        DirectoryCheck& check = tree_.directory.emplace();
        const auto listed = readDicomDirectory(directoryPath);
        if (!listed) {
            check.damage = listed.error().message.about({});
            return;
        }
        const std::map<std::string, std::string> there = namesBelow(fs::path(directoryPath).parent_path());
        std::set<std::string> wanted, series;
        for (const DirectoryEntry& file : listed.value()) {
            const auto found = there.find(normalizedFileName(file.name));
            if (found != there.end()) {
                wanted.insert(found->second);
            } else {
                collector_.addMissingFile(file);
                ++check.missingFiles;
            }
            series.insert(file.identity.seriesUid);
        }
        check.files = listed.value().size();
        check.series = series.size();
        check.unlistedFiles = static_cast<std::size_t>(std::ranges::count_if(files_, [&](const std::string& path) {
            return !wanted.contains(path) && !isDicomDirectory(path) && mayBeImage(path);
        }));
        files_.assign(wanted.begin(), wanted.end());
        tree_.foundFiles = files_.size();
    }

    void dropDirectories()
    {
        std::erase_if(files_, isDicomDirectory);
        tree_.foundFiles = files_.size();
    }

    StudyTree read()
    {
        for (const std::string& path : files_) {
            if (tree_.isStopped || isStopped()) {
                break;
            }
            readOne(path);
            ++tree_.readFiles;
            groupWhenDue();
        }
        group();
        return *shown_;
    }

private:
    void readOne(const std::string& path)
    {
        auto read = readStudyFile(path);
        if (!read) {
            tree_.damagedFiles.push_back({path, read.error().message.about({})});
            return;
        }
        std::optional<StudyFile> file = std::move(read).value();
        if (!file) {
            ++tree_.otherFiles;
            return;
        }
        if (file->images.damage) {
            tree_.damagedFiles.push_back({path, *file->images.damage});
        }
        collector_.add(*std::move(file));
    }

    void groupWhenDue()
    {
        if (observe_ && Clock::now() - groupedAt_ > std::max<Clock::duration>(listedEvery, groupingShare * grouping_)) {
            group();
        }
    }

    void group()
    {
        const auto begin = Clock::now();
        StudyTree tree = collector_.tree();
        tree_.patients.swap(tree.patients);
        shown_ = std::make_shared<const StudyTree>(tree_);
        groupedAt_ = Clock::now();
        grouping_ = groupedAt_ - begin;
    }

    bool isStopped()
    {
        const StudyProgress progress{tree_.readFiles, tree_.foundFiles, shown_};
        tree_.isStopped = tree_.isStopped || (observe_ && observe_(progress) == core::ObserverDecision::Stop);
        return tree_.isStopped;
    }

    /// Returns paths keyed by their names relative to a folder, as written in a DICOMDIR.
    std::map<std::string, std::string> namesBelow(const fs::path& folder) const
    {
        std::map<std::string, std::string> names;
        for (const std::string& path : files_) {
            names.emplace(normalizedFileName(fs::path(path).lexically_relative(folder).generic_string()), path);
        }
        return names;
    }

    const StudyObserver& observe_;
    std::vector<std::string> files_;
    bool isFinished_ = false;   ///< set once the scan was canceled or has reached the maximum number of files
    StudyCollector collector_;
    StudyTree tree_;
    std::shared_ptr<const StudyTree> shown_;
    Clock::time_point groupedAt_ = Clock::now();
    Clock::duration grouping_{0};
};

/// Returns the DICOMDIR of a folder; empty if there is none.
std::string directoryIn(const std::string& folder)
{
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(folder, failed)) {
        std::error_code unknown;
        if (isDicomDirectory(entry.path().string()) && entry.is_regular_file(unknown)) {
            return entry.path().string();
        }
    }
    return {};
}

}   // namespace

bool isDicomDirectory(const std::string& path)
{
    return normalizedFileName(fs::path(path).filename().string()) == "dicomdir";
}

core::Result<StudyTree> readStudies(const std::string& location, StudyScope scope, const StudyObserver& observe)
{
    std::error_code unknown;
    const bool isFile = fs::is_regular_file(location, unknown);
    const fs::path absolute = fs::absolute(location, unknown).lexically_normal();
    const std::string folder = (isFile || !absolute.has_filename() ? absolute.parent_path() : absolute).string();
    const std::string directory = isFile ? absolute.string() : directoryIn(folder);
    Scan scan(observe);
    if (auto found = scan.find(folder); !found) {
        return found.error();
    }
    if (!directory.empty() && scope == StudyScope::Listed) {
        scan.keepListed(directory);
    }
    scan.dropDirectories();
    return scan.read();
}

core::Result<StudyTree> readSeriesFolders(const std::vector<std::string>& folders, const StudyObserver& observe)
{
    Scan scan(observe);
    for (const std::string& folder : folders) {
        if (auto found = scan.find(folder); !found) {
            return found.error();
        }
    }
    return scan.read();
}

}   // namespace angiopose::io
