#include "io/archive/store/cache.h"

#include "io/archive/model/query.h"
#include "io/archive/store/object_store.h"
#include "io/messages/messages.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view incompleteMark = ".begun";

std::vector<fs::path> entriesOf(const fs::path& folder)
{
    std::vector<fs::path> entries;
    std::error_code failed;
    for (fs::directory_iterator each(folder, failed), end; !failed && each != end; each.increment(failed)) {
        entries.push_back(each->path());
    }
    return entries;
}

/// Returns whether the cache created the file: its name is `<uid>.dcm`.
bool isObjectFile(const fs::path& path)
{
    std::error_code failed;
    return path.extension() == ".dcm" && isUid(path.stem().string()) && fs::is_regular_file(path, failed);
}

bool isUidFolder(const fs::path& path)
{
    std::error_code failed;
    return isUid(path.filename().string()) && fs::is_directory(fs::symlink_status(path, failed));
}

std::chrono::system_clock::time_point changedAt(const fs::path& path)
{
    std::error_code failed;
    const auto written = fs::last_write_time(path, failed);
    return failed ? std::chrono::system_clock::time_point{}
                  : std::chrono::time_point_cast<std::chrono::system_clock::duration>(
                        std::chrono::file_clock::to_sys(written));
}

CachedSeries seriesAt(const fs::path& folder)
{
    CachedSeries series;
    series.studyUid = folder.parent_path().filename().string();
    series.seriesUid = folder.filename().string();
    series.folder = folder.string();
    series.lastUsed = changedAt(folder);
    std::error_code failed;
    series.isComplete = !fs::exists(folder / incompleteMark, failed);
    for (const fs::path& file : entriesOf(folder)) {
        const auto size = isObjectFile(file) ? fs::file_size(file, failed) : 0;
        if (size > 0 && !failed) {
            ++series.objects;
            series.bytes += size;
        }
    }
    return series;
}

/// Deletes a series, after marking it as incomplete in case of an interruption. Returns the number of deleted objects.
std::size_t deleteSeries(const fs::path& folder)
{
    markSeriesIncomplete(folder.string());
    std::error_code failed;
    std::size_t dropped = 0;
    for (const fs::path& file : entriesOf(folder)) {
        dropped += isObjectFile(file) && fs::remove(file, failed) ? 1 : 0;
    }
    fs::remove(folder / incompleteMark, failed);
    fs::remove(folder, failed);   // succeeds only if the folder is empty
    fs::remove(folder.parent_path(), failed);
    return dropped;
}

}   // namespace

std::vector<CachedSeries> listCachedSeries(const std::string& root)
{
    std::vector<CachedSeries> all;
    for (const fs::path& study : entriesOf(root)) {
        if (!isUidFolder(study)) {
            continue;
        }
        for (const fs::path& series : entriesOf(study)) {
            if (isUidFolder(series)) {
                all.push_back(seriesAt(series));
            }
        }
    }
    std::ranges::sort(all, [](const CachedSeries& a, const CachedSeries& b) {
        return std::tie(a.lastUsed, a.folder) < std::tie(b.lastUsed, b.folder);
    });
    return all;
}

std::uint64_t shrinkCache(const std::string& root, std::uint64_t maxBytes, const std::string& keptFolder)
{
    const auto all = listCachedSeries(root);
    std::uint64_t left = 0;
    for (const CachedSeries& series : all) {
        left += series.bytes;
    }
    for (const CachedSeries& series : all) {
        if (left <= maxBytes) {
            break;
        }
        if (series.folder != keptFolder) {
            deleteSeries(series.folder);
            left -= series.bytes;
        }
    }
    return left;
}

core::Result<std::size_t> clearCache(const std::string& root)
{
    std::size_t dropped = 0;
    for (const CachedSeries& series : listCachedSeries(root)) {
        dropped += deleteSeries(series.folder);
    }
    const auto left = listCachedSeries(root);
    if (std::ranges::any_of(left, [](const CachedSeries& series) { return series.objects > 0; })) {
        const auto why = std::make_error_code(std::errc::permission_denied);
        return core::Error(messages::archiveNoFolder(why.message()).about(root));
    }
    return dropped;
}

void markSeriesIncomplete(const std::string& folder)
{
    std::error_code failed;
    fs::create_directories(folder, failed);
    std::ofstream(fs::path(folder) / incompleteMark).flush();
    fs::last_write_time(folder, fs::file_time_type::clock::now(), failed);
}

void markSeriesComplete(const std::string& folder)
{
    std::error_code failed;
    fs::remove(fs::path(folder) / incompleteMark, failed);
    fs::last_write_time(folder, fs::file_time_type::clock::now(), failed);
}

std::string defaultCacheFolder()
{
    const char* cache = std::getenv("XDG_CACHE_HOME");
    const char* home = std::getenv("HOME");
    const fs::path base =
        cache != nullptr && *cache == '/' ? fs::path(cache) : fs::path(home != nullptr ? home : ".") / ".cache";
    return (base / "angiopose" / "archive").string();
}

}   // namespace angiopose::io
