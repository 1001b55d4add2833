#include "io/volume_file.h"

#include "io/dicom/dicom_file.h"
#include "io/dicom_series.h"
#include "io/messages/messages.h"
#include "io/series/dicom_segmentation.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/volume/open_stored_volume.h"
#include "io/volume/read_voxels.h"

#include <algorithm>
#include <bitset>
#include <filesystem>

namespace angiopose::io {
namespace {

/// Returns the series with this ID, or the only volume if no ID is given.
core::Result<DicomSeries> selectSeries(std::vector<DicomSeries> all, const std::string& seriesId,
                                       const std::string& folder)
{
    std::erase_if(all, [&](const DicomSeries& series) {
        return seriesId.empty() ? series.isAngiogram || series.problem.has_value() : series.id != seriesId;
    });
    if (all.empty()) {
        return fileError(folder, seriesId.empty() ? messages::seriesNoneMakesVolume()
                                                  : messages::seriesNotHere(seriesId.substr(0, 80)));
    }
    if (all.size() > 1) {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < std::min<std::size_t>(all.size(), 4); ++i) {
            names.push_back(all[i].description.empty() ? "–" : all[i].description);
        }
        if (all.size() > names.size()) {
            names.emplace_back("…");
        }
        return fileError(folder, messages::seriesSeveral(all.size(), names));
    }
    return std::move(all.front());
}

core::Result<DicomSeries> seriesInFolder(const std::string& folder, const std::string& seriesId,
                                         const ReadObserver& observe)
{
    auto all = listSeries(folder, observe);
    return all ? selectSeries(std::move(all).value(), seriesId, folder) : all.error();
}

core::Result<LoadedVolume> readDicomVolume(const std::string& path, const std::string& seriesId,
                                           const ReadObserver& observe)
{
    const ReadObserver observeListing = progressPart(observe, 0.0, 0.1);
    const auto series =
        isFolder(path) ? seriesInFolder(path, seriesId, observeListing) : seriesOfFile(path, observeListing);
    if (!series) {
        return series.error();
    }
    if (series.value().problem) {
        return fileError(path, *series.value().problem);
    }
    LoadedVolume loaded;
    loaded.format = "DICOM series";
    loaded.identity = series.value().identity;
    loaded.seriesId = series.value().id;
    loaded.warnings = series.value().warnings;
    auto volume = readSeries(series.value(), progressPart(observe, 0.1, 1.0), loaded.warnings);
    if (!volume) {
        return volume.error();
    }
    loaded.volume = std::move(volume).value();
    return loaded;
}

/// Whether the values look like labels: whole numbers from 0, mostly background, the rest in homogeneous regions.
template <class ValueAt>
bool areLabels(std::size_t count, const ValueAt& valueAt)
{
    std::bitset<65536> seen;
    std::size_t inside = 0, inPieces = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double value = valueAt(i);
        if (value < 0.0) {
            return false;
        }
        seen.set(std::min<std::size_t>(static_cast<std::size_t>(value), 65535));
        if (value > 0.0) {
            ++inside;
            inPieces += i + 1 < count && valueAt(i + 1) == value ? 1 : 0;
        }
    }
    const bool isMask = seen.count() <= 3;
    return seen.test(0) && (isMask || (2 * inside < count && 2 * inPieces > inside && seen.count() <= 512));
}

}   // namespace

bool isVolumeFile(const std::string& path)
{
    return isStoredVolume(path);
}

core::Result<VolumeSummary> describeVolume(const std::string& path)
{
    const auto stored = openStoredVolume(path);
    if (!stored) {
        return stored.error();
    }
    const StoredVolume& head = stored.value();
    if (const auto plausible = checkVoxels(head); !plausible) {
        return plausible.error();
    }
    return VolumeSummary{head.format,    std::string(nameOf(head.type)), head.geometry, head.slope,
                         head.intercept, head.isDeclaredLabelMap,        head.warnings};
}

core::Result<LoadedVolume> readVolume(const std::string& path, const std::string& seriesId, const ReadObserver& observe)
{
    std::error_code failed;
    if (std::filesystem::is_directory(path, failed) || isDicomFile(path)) {
        return readDicomVolume(path, seriesId, observe);
    }
    auto opened = openStoredVolume(path);
    if (!opened) {
        return opened.error();
    }
    StoredVolume stored = std::move(opened).value();
    LoadedVolume loaded;
    loaded.format = stored.format;
    loaded.isDeclaredLabelMap = stored.isDeclaredLabelMap;
    loaded.warnings = stored.warnings;
    auto volume = readVoxels(stored, observe, loaded.warnings);
    if (!volume) {
        return volume.error();
    }
    loaded.volume = std::move(volume).value();
    return loaded;
}

core::Result<core::LabelVolume> readLabels(const std::string& path, const ReadObserver& observe)
{
    if (isDicomFile(path)) {
        auto labels = readDicomSegmentation(path, observe);
        const bool isSlice = labels && (labels.value().geometry.size.array() < 2).any();
        return isSlice ? fileError(path, messages::labelsOnePlane()) : std::move(labels);
    }
    const auto stored = openStoredVolume(path);
    return stored ? readLabelVoxels(stored.value(), observe) : stored.error();
}

bool looksLikeLabels(const core::Volume& volume)
{
    const bool isPlain = volume.slope == 1.0 && volume.intercept == std::floor(volume.intercept);
    return isPlain && areLabels(volume.voxels.size(), [&](std::size_t i) { return volume.value(i); });
}

bool looksLikeLabels(const core::LabelVolume& image)
{
    return areLabels(image.voxels.size(), [&](std::size_t i) { return static_cast<double>(image.voxels[i]); });
}

core::LabelVolume labelsOf(const core::Volume& volume)
{
    core::LabelVolume labels(volume.geometry);
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
        labels.voxels[i] = static_cast<std::uint16_t>(std::clamp(volume.value(i), 0.0, 65535.0));
    }
    return labels;
}

}   // namespace angiopose::io
