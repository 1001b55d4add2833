#include "io/dicom_series.h"

#include "io/dicom/dicom_file.h"
#include "io/file_hash.h"
#include "io/messages/messages.h"
#include "io/series/group_slices.h"
#include "io/support/file_error.h"
#include "io/support/files_in_folder.h"
#include "io/support/input_bytes.h"

#include <algorithm>
#include <filesystem>

namespace angiopose::io {
namespace {

core::Result<std::vector<DicomSeries>> scan(const std::string& folder, FolderDepth reach, const ReadObserver& observe)
{
    const auto files = filesInFolder(folder, reach);
    if (!files) {
        return files.error();
    }
    std::vector<DicomImages> images;
    const auto total = static_cast<double>(files.value().size());
    for (std::size_t i = 0; i < files.value().size(); ++i) {
        if (i % 16 == 0 && isStopRequested(observe, static_cast<double>(i) / total)) {
            return readingCanceled(folder);
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
    auto series = scan(folder, FolderDepth::Recursive, observe);
    if (series && series.value().empty()) {
        return fileError(folder, messages::seriesNone());
    }
    return series;
}

core::Result<DicomSeries> seriesOfFile(const std::string& path, const ReadObserver& observe)
{
    const auto own = readSliceRecords(path);
    if (!own) {
        return own.error();
    }
    std::string folder = std::filesystem::path(path).parent_path().string();
    auto found = own.value().slices.size() > 1 ? core::Result<std::vector<DicomSeries>>(groupSlices({own.value()}))
                                               : scan(folder.empty() ? "." : folder, FolderDepth::TopLevel, observe);
    if (!found) {
        return found.error();
    }
    std::vector<DicomSeries> all = std::move(found).value();
    std::error_code failed;
    for (DicomSeries& series : all) {
        const bool isOwn = std::any_of(series.slices.begin(), series.slices.end(), [&](const SliceRecord& slice) {
            return slice.path == path || std::filesystem::equivalent(slice.path, path, failed);
        });
        if (isOwn) {
            return std::move(series);
        }
    }
    // Grouping removed the file as a duplicate of another file in the folder: use this file alone.
    std::vector<DicomSeries> alone = groupSlices({own.value()});
    return alone.empty() ? core::Result<DicomSeries>(fileError(path, messages::seriesFileWithoutImage()))
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
