#include "io/volume_file.h"

#include "io/dicom/dicom_file.h"
#include "io/dicom_series.h"
#include "io/messages/messages.h"
#include "io/series/dicom_segmentation.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"
#include "io/support/system/current_process.h"
#include "io/volume/open_stored_volume.h"
#include "io/volume/quantization.h"
#include "io/volume/robust_range.h"
#include "io/volume/stored_volume.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <type_traits>

namespace angiopose::io {
namespace {

core::Error tooLarge(const StoredVolume& stored)
{
    return fileError(stored.path, messages::volumeLargerThanMemory());
}

/// Reads voxels of up to 16 bits directly into the memory of `place`, then widens them in place with `convert(value)`,
/// from last to first.
template <class T, class Level, class Convert>
core::Status readInPlace(const StoredVolume& stored, std::vector<Level>& place, const ReadObserver& observe,
                         const Convert& convert)
{
    static_assert(sizeof(T) <= sizeof(Level));
    char* bytes = reinterpret_cast<char*>(place.data());
    if (const auto filled = stored.voxels->read(bytes, observe); !filled) {
        return filled;
    }
    for (std::size_t i = place.size(); i-- > 0;) {
        T value;
        std::memcpy(&value, bytes + i * sizeof(T), sizeof(T));
        place[i] = convert(value);
    }
    return core::Done{};
}

/// Reads the voxels as stored, for types whose range must be determined before conversion to 16 bits.
template <class T>
core::Result<std::unique_ptr<T[]>> readApart(const StoredVolume& stored, const ReadObserver& observe)
{
    auto values = std::make_unique_for_overwrite<T[]>(stored.geometry.voxelCount());
    const auto filled = stored.voxels->read(reinterpret_cast<char*>(values.get()), observe);
    return filled ? core::Result<std::unique_ptr<T[]>>(std::move(values)) : filled.error();
}

template <class T>
ValueRange rangeOf(const T* values, std::size_t count)
{
    ValueRange range;
    if constexpr (std::is_integral_v<T>) {
        const auto [low, high] = std::minmax_element(values, values + count);
        range.low = static_cast<double>(*low);
        range.high = static_cast<double>(*high);
    } else {
        for (std::size_t i = 0; i < count; ++i) {
            range.add(static_cast<double>(values[i]));
        }
    }
    return range;
}

void noteLosses(const StoredVolume& stored, const ValueRange& range, const Quantization& quantization,
                core::Messages& warnings)
{
    if (range.missing > 0) {
        warnings.push_back(messages::volumeNotNumbers(range.missing));
    }
    if (!range.isInteger || quantization.scale != 1.0) {
        warnings.push_back(roundingNote(stored.slope * quantization.scale, std::string(nameOf(stored.type))));
    }
}

template <class T>
void quantize(const T* values, const Quantization& quantization, const ValueRange& range,
              std::vector<std::int16_t>& voxels)
{
    const bool isExact = quantization.scale == 1.0;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        const auto raw = static_cast<double>(values[i]);
        const double value = std::isfinite(raw) ? std::clamp(raw, range.low, range.high) : range.low;
        voxels[i] = isExact && value == std::trunc(value) ? static_cast<std::int16_t>(value - quantization.offset)
                                                          : quantization.voxel(value);
    }
}

template <class T>
core::Result<core::Volume> readNarrow(const StoredVolume& stored, const ReadObserver& observe)
{
    constexpr bool isWide = std::is_same_v<T, std::uint16_t>;
    constexpr int offset = isWide ? 32768 : 0;
    core::Volume volume(stored.geometry);
    volume.slope = stored.slope;
    volume.intercept = stored.slope * offset + stored.intercept;
    const auto filled = readInPlace<T>(stored, volume.voxels, observe, [](T value) {
        return static_cast<std::int16_t>(static_cast<int>(value) - offset);
    });
    return filled ? core::Result<core::Volume>(std::move(volume)) : filled.error();
}

template <class T>
core::Result<core::Volume> readWide(const StoredVolume& stored, const ReadObserver& observe, core::Messages& warnings)
{
    const auto apart = readApart<T>(stored, observe);
    if (!apart) {
        return apart.error();
    }
    const T* values = apart.value().get();
    const std::size_t count = stored.geometry.voxelCount();
    const ValueRange whole = rangeOf(values, count);
    if (whole.missing == count) {
        return fileError(stored.path, messages::volumeNoNumbers());
    }
    const auto valueAt = [values](std::size_t i) { return static_cast<double>(values[i]); };
    const ValueRange range = robustRange(whole, count, valueAt);
    if (const std::size_t outside =
            range.low > whole.low || range.high < whole.high ? countOutside(range, count, valueAt) : 0;
        outside > 0) {
        warnings.push_back(messages::volumeStrayValues(outside, toText(stored.slope * range.low + stored.intercept),
                                                       toText(stored.slope * range.high + stored.intercept)));
    }
    const Quantization quantization = quantizationOf(range);
    noteLosses(stored, range, quantization, warnings);
    core::Volume volume(stored.geometry);
    volume.slope = stored.slope * quantization.scale;
    volume.intercept = stored.slope * quantization.offset + stored.intercept;
    quantize(values, quantization, range, volume.voxels);
    return volume;
}

/// Returns the label for a value after slope and intercept, up to float rounding; negative if it is not a label.
double labelOf(double value)
{
    const double label = std::round(value);
    return label >= 0.0 && label <= storedLevels && std::abs(value - label) <= 1e-3 ? label : -1.0;
}

template <class T>
core::Result<core::LabelVolume> labelsAs(const StoredVolume& stored, const ReadObserver& observe)
{
    core::LabelVolume labels(stored.geometry);
    std::optional<double> wrong;
    const auto voxelOf = [&](T raw) {
        const double value = stored.slope * static_cast<double>(raw) + stored.intercept;
        const double label = labelOf(value);
        wrong = label < 0.0 ? value : wrong;
        return static_cast<std::uint16_t>(std::max(label, 0.0));
    };
    if constexpr (sizeof(T) <= 2) {
        if (const auto filled = readInPlace<T>(stored, labels.voxels, observe, voxelOf); !filled) {
            return filled.error();
        }
    } else {
        const auto apart = readApart<T>(stored, observe);
        if (!apart) {
            return apart.error();
        }
        for (std::size_t i = labels.voxels.size(); i-- > 0;) {
            labels.voxels[i] = voxelOf(apart.value()[i]);
        }
    }
    if (wrong) {
        return fileError(stored.path, messages::labelsNoWholeNumber(toText(*wrong)));
    }
    return labels;
}

/// Fails if the file is too short for its voxels or they do not fit into memory; does not read any voxels.
core::Status checkVoxels(const StoredVolume& stored)
{
    if (const auto there = stored.voxels->check(); !there) {
        return there;
    }
    const std::size_t apart = bytesOf(stored.type) > 2 ? bytesOf(stored.type) : 0;
    const double needed = static_cast<double>(stored.geometry.voxelCount()) * static_cast<double>(2 + apart);
    return needed > 0.9 * physicalMemoryBytes() ? core::Status(tooLarge(stored)) : core::Done{};
}

/// Reads the voxels of a stored volume as 16 bits, directly into place. Keeps every value of types with up to 16 bits
/// and of whole numbers that span at most 16 bits; rounds others to 65535 steps, with a warning that states the step.
core::Result<core::Volume> readVoxels(const StoredVolume& stored, const ReadObserver& observe, core::Messages& warnings)
{
    if (const auto plausible = checkVoxels(stored); !plausible) {
        return plausible.error();
    }
    try {
        return visitVoxelType(stored.type, [&](auto kind) -> core::Result<core::Volume> {
            using T = decltype(kind);
            if constexpr (sizeof(T) <= 2) {
                return readNarrow<T>(stored, observe);
            } else {
                return readWide<T>(stored, observe, warnings);
            }
        });
    } catch (const std::bad_alloc&) {
        return tooLarge(stored);
    }
}

/// Reads the voxels of a stored label image; fails if a value is not a label (fractional, negative, or above 65535).
core::Result<core::LabelVolume> readLabelVoxels(const StoredVolume& stored, const ReadObserver& observe)
{
    if (const auto plausible = checkVoxels(stored); !plausible) {
        return plausible.error();
    }
    try {
        return visitVoxelType(stored.type, [&](auto kind) { return labelsAs<decltype(kind)>(stored, observe); });
    } catch (const std::bad_alloc&) {
        return tooLarge(stored);
    }
}

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

/// Returns whether the values look like labels: whole numbers from 0, mostly background, the rest in homogeneous areas.
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
