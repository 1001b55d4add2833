#include "io/scan_reference.h"

#include "io/dicom/dicom_file.h"
#include "io/dicom_series.h"
#include "io/messages/messages.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <filesystem>

namespace angiopose::io {
namespace {

core::Result<DicomSeries> scanSeries(const std::string& path, const std::string& seriesId)
{
    if (!std::filesystem::is_directory(path)) {
        return seriesOfFile(path);
    }
    auto all = listSeries(path);
    if (!all) {
        return all.error();
    }
    const auto isIt = [&seriesId](const DicomSeries& series) {
        return seriesId.empty() ? !series.isAngiogram && !series.problem : series.id == seriesId;
    };
    const auto found = std::ranges::find_if(all.value(), isIt);
    return found == all.value().end() ? core::Result<DicomSeries>(fileError(path, messages::seriesNoneMakesVolume()))
                                      : *found;
}

}   // namespace

core::Result<ScanReference> readScanReference(const std::string& path, const std::string& seriesId)
{
    if (!std::filesystem::is_directory(path) && !isDicomFile(path)) {
        const auto empty = readSourceImage(path);
        return empty ? core::Result<ScanReference>(ScanReference{empty.value(), {}}) : empty.error();
    }
    const auto series = scanSeries(path, seriesId);
    if (!series) {
        return series.error();
    }
    const std::vector<SliceRecord>& slices = series.value().slices;
    if (slices.empty()) {
        return fileError(path, messages::seriesNoneMakesVolume());
    }
    auto source = readSourceImage(slices.front().path);
    if (!source) {
        return source.error();
    }
    ScanReference scan{std::move(source).value(), {}};
    for (const SliceRecord& slice : slices) {
        if (slice.position) {
            scan.slices.push_back({slice.sopInstanceUid, slice.frame, scan.source.frames > 1, *slice.position});
        }
    }
    return scan;
}

}   // namespace angiopose::io
