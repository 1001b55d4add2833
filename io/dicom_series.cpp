#include "io/dicom_series.h"

#include "io/dicom/dicom_file.h"
#include "io/file_hash.h"
#include "io/messages/says.h"
#include "io/series/group_slices.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"

#include <algorithm>
#include <filesystem>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxFiles = 50'000;
constexpr int maxFolderDepth = 8;

enum class Reach { FolderOnly, Below };

/// Regular files in a folder (and below), by name.
core::Result<std::vector<std::string>> filesIn(const std::string& folder, Reach reach)
{
    std::vector<std::string> files;
    std::error_code failed;
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, failed);
    if (failed) {
        return fileError(folder, says::folderNotRead(failed.message()));
    }
    for (; at != fs::recursive_directory_iterator(); at.increment(failed)) {
        if (failed || files.size() > maxFiles) {
            return fileError(folder, failed ? says::folderNotReadToEnd() : says::folderTooFull());
        }
        if (reach == Reach::FolderOnly || at.depth() >= maxFolderDepth) {
            at.disable_recursion_pending();
        }
        std::error_code unknown;
        if (at->is_regular_file(unknown) && at->path().filename() != "DICOMDIR") {
            files.push_back(at->path().string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

core::Result<std::vector<DicomSeries>> scan(const std::string& folder, Reach reach, const ReadObserver& observe)
{
    const auto files = filesIn(folder, reach);
    if (!files) {
        return files.error();
    }
    std::vector<DicomImages> images;
    const auto total = static_cast<double>(files.value().size());
    for (std::size_t i = 0; i < files.value().size(); ++i) {
        if (i % 16 == 0 && isStopWished(observe, static_cast<double>(i) / total)) {
            return stoppedReading(folder);
        }
        if (auto image = readSliceRecords(files.value()[i])) {
            images.push_back(std::move(image).value());
        }
    }
    return groupSlices(std::move(images));
}

}   // namespace

core::Result<std::vector<DicomSeries>> listSeries(const std::string& folder, const ReadObserver& observe)
{
    auto series = scan(folder, Reach::Below, observe);
    if (series && series.value().empty()) {
        return fileError(folder, says::seriesNone());
    }
    return series;
}

core::Result<DicomSeries> seriesOfFile(const std::string& path, const ReadObserver& observe)
{
    const auto own = readSliceRecords(path);
    if (!own) {
        return own.error();
    }
    std::string folder = fs::path(path).parent_path().string();
    auto found = own.value().slices.size() > 1 ? core::Result<std::vector<DicomSeries>>(groupSlices({own.value()}))
                                               : scan(folder.empty() ? "." : folder, Reach::FolderOnly, observe);
    if (!found) {
        return found.error();
    }
    std::vector<DicomSeries> all = std::move(found).value();
    std::error_code failed;
    for (DicomSeries& series : all) {
        const bool isOwn = std::any_of(series.slices.begin(), series.slices.end(), [&](const SliceRecord& slice) {
            return slice.path == path || fs::equivalent(slice.path, path, failed);
        });
        if (isOwn) {
            return std::move(series);
        }
    }
    // Dropped as a copy of another file beside it: alone then.
    std::vector<DicomSeries> alone = groupSlices({own.value()});
    return alone.empty() ? core::Result<DicomSeries>(fileError(path, says::seriesFileWithoutImage()))
                         : std::move(alone.front());
}

core::Result<std::string> sha256OfSeries(const DicomSeries& series)
{
    std::string hashes;
    const std::string* last = nullptr;
    for (const SliceRecord& slice : series.slices) {
        if (last && *last == slice.path) {
            continue;
        }
        last = &slice.path;
        const auto hash = sha256OfFile(slice.path);
        if (!hash) {
            return hash.error();
        }
        hashes += hash.value();
    }
    return sha256OfText(hashes);
}

}   // namespace angiopose::io