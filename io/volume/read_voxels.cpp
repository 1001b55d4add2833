#include "io/volume/read_voxels.h"

#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/volume/byte_stream.h"
#include "io/volume/nifti.h"
#include "io/volume/nifti_header.h"
#include "io/volume/quantization.h"

#include <unistd.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

namespace angiopose::io {
namespace {

constexpr std::size_t chunkVoxels = std::size_t{1} << 18;
constexpr double greatestInflation = 1100.0;   // deflate packs at most 1032 to 1
core::Error cutShort(const StoredVolume& stored)
{
    return fileError(stored.source.path, says::volumePackingDamaged());
}

double memoryBytes()
{
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// The stream at the first voxel.
core::Result<ByteStream> openVoxels(const StoredVolume& stored)
{
    const VoxelSource& source = stored.source;
    auto opened = ByteStream::open(source);
    if (!opened) {
        return opened;
    }
    ByteStream stream = std::move(opened).value();
    std::uint64_t skip = source.skip;
    if (source.isAtEnd) {
        const std::uint64_t needed = stored.geometry.voxelCount() * bytesOf(stored.type);
        const std::uint64_t length = stream.drain();
        auto again = ByteStream::open(source);
        if (!again || length < needed) {
            return cutShort(stored);
        }
        stream = std::move(again).value();
        skip = length - needed;
    }
    return stream.skip(skip) ? core::Result<ByteStream>(std::move(stream)) : cutShort(stored);
}

template <class T>
void toHostOrder(std::vector<T>& values, std::size_t count, bool isBigEndian)
{
    if constexpr (sizeof(T) > 1) {
        if (isBigEndian == (std::endian::native == std::endian::big)) {
            return;
        }
        for (std::size_t i = 0; i < count; ++i) {
            std::array<char, sizeof(T)> bytes;
            std::memcpy(bytes.data(), &values[i], sizeof(T));
            std::reverse(bytes.begin(), bytes.end());
            std::memcpy(&values[i], bytes.data(), sizeof(T));
        }
    }
}

/// Calls `use(values, count, first voxel)` for one chunk after the other.
template <class T, class Use>
core::Status forEachChunk(const StoredVolume& stored, const ReadObserver& observe, const Use& use)
{
    auto opened = openVoxels(stored);
    if (!opened) {
        return opened.error();
    }
    ByteStream stream = std::move(opened).value();
    const std::size_t total = stored.geometry.voxelCount();
    std::vector<T> chunk(std::min(chunkVoxels, total));
    for (std::size_t first = 0; first < total; first += chunk.size()) {
        if (isStopWished(observe, static_cast<double>(first) / static_cast<double>(total))) {
            return stoppedReading(stored.path);
        }
        const std::size_t count = std::min(chunk.size(), total - first);
        if (!stream.read(reinterpret_cast<char*>(chunk.data()), count * sizeof(T))) {
            return cutShort(stored);
        }
        toHostOrder(chunk, count, stored.isBigEndian);
        if (core::Status used = use(chunk, count, first); !used) {
            return used;
        }
    }
    return core::Done{};
}

/// Runs `work` with a value of the C++ type that `type` names.
template <class Work>
auto withType(VoxelType type, const Work& work)
{
    switch (type) {
        case VoxelType::Int8:
            return work(std::int8_t{});
        case VoxelType::Uint8:
            return work(std::uint8_t{});
        case VoxelType::Int16:
            return work(std::int16_t{});
        case VoxelType::Uint16:
            return work(std::uint16_t{});
        case VoxelType::Int32:
            return work(std::int32_t{});
        case VoxelType::Uint32:
            return work(std::uint32_t{});
        case VoxelType::Int64:
            return work(std::int64_t{});
        case VoxelType::Uint64:
            return work(std::uint64_t{});
        case VoxelType::Float32:
            return work(float{});
        default:
            return work(double{});
    }
}

template <class T>
core::Result<ValueRange> rangeOf(const StoredVolume& stored, const ReadObserver& observe)
{
    ValueRange range;
    const auto scanned =
        forEachChunk<T>(stored, observe, [&](const std::vector<T>& values, std::size_t count, std::size_t) {
            for (std::size_t i = 0; i < count; ++i) {
                range.add(static_cast<double>(values[i]));
            }
            return core::Status(core::Done{});
        });
    return scanned ? core::Result<ValueRange>(range) : scanned.error();
}

void noteLosses(const StoredVolume& stored, const ValueRange& range, const Quantization& quantization,
                core::Messages& warnings)
{
    if (range.missing > 0) {
        warnings.push_back(says::volumeNotNumbers(range.missing));
    }
    if (!range.isWhole || quantization.scale != 1.0) {
        warnings.push_back(roundingNote(stored.slope * quantization.scale, std::string(nameOf(stored.type))));
    }
}

/// Reads every voxel by `quantization`; 16-bit numbers need no rounding.
template <class T>
core::Result<core::Volume> quantized(const StoredVolume& stored, const Quantization& quantization, double lowest,
                                     const ReadObserver& observe)
{
    core::Volume volume(stored.geometry);
    volume.slope = stored.slope * quantization.scale;
    volume.intercept = stored.slope * quantization.offset + stored.intercept;
    const auto filled =
        forEachChunk<T>(stored, observe, [&](const std::vector<T>& values, std::size_t count, std::size_t first) {
            std::int16_t* out = volume.voxels.data() + first;
            for (std::size_t i = 0; i < count; ++i) {
                if constexpr (sizeof(T) <= 2) {
                    out[i] =
                        static_cast<std::int16_t>(static_cast<int>(values[i]) - static_cast<int>(quantization.offset));
                } else {
                    const auto raw = static_cast<double>(values[i]);
                    out[i] = quantization.voxel(std::isfinite(raw) ? raw : lowest);
                }
            }
            return core::Status(core::Done{});
        });
    if (!filled) {
        return filled.error();
    }
    return volume;
}

template <class T>
core::Result<core::Volume> readAs(const StoredVolume& stored, const ReadObserver& observe, core::Messages& warnings)
{
    if constexpr (sizeof(T) <= 2) {
        const bool isWide = std::is_same_v<T, std::uint16_t>;
        return quantized<T>(stored, {1.0, isWide ? -lowestStored : 0.0}, 0.0, observe);
    } else {
        const auto range = rangeOf<T>(stored, partOf(observe, 0.0, 0.5));
        if (!range) {
            return range.error();
        }
        if (range.value().missing == stored.geometry.voxelCount()) {
            return fileError(stored.path, says::volumeNoNumbers());
        }
        const Quantization quantization = quantizationOf(range.value());
        noteLosses(stored, range.value(), quantization, warnings);
        return quantized<T>(stored, quantization, range.value().low, partOf(observe, 0.5, 1.0));
    }
}

template <class T>
core::Result<core::LabelVolume> labelsAs(const StoredVolume& stored, const ReadObserver& observe)
{
    core::LabelVolume labels(stored.geometry);
    const auto filled =
        forEachChunk<T>(stored, observe, [&](const std::vector<T>& values, std::size_t count, std::size_t first) {
            for (std::size_t i = 0; i < count; ++i) {
                const double value = stored.slope * static_cast<double>(values[i]) + stored.intercept;
                if (!(value >= 0.0 && value <= storedLevels && value == std::floor(value))) {
                    return core::Status(fileError(stored.path, says::labelsNoWholeNumber(toText(value))));
                }
                labels.voxels[first + i] = static_cast<std::uint16_t>(value);
            }
            return core::Status(core::Done{});
        });
    if (!filled) {
        return filled.error();
    }
    return labels;
}

/// A header that points at a whole volume and says nothing of the header in there would show that as voxels.
bool isHeaderAmongVoxels(const StoredVolume& stored)
{
    const VoxelSource& source = stored.source;
    if (source.path == stored.path || source.isAtEnd || source.offset + source.skip > 0) {
        return false;
    }
    auto opened = ByteStream::open(source);
    if (!opened) {
        return false;
    }
    ByteStream stream = std::move(opened).value();
    std::string head(niftiHeadSize, '\0');
    head.resize(stream.readSome(head.data(), head.size()));
    return head.starts_with("NRRD000") || niftiHeaderOf(head);
}

}   // namespace

core::Status checkVoxels(const StoredVolume& stored)
{
    const VoxelSource& source = stored.source;
    if (!std::filesystem::exists(source.path)) {
        return fileError(stored.path,
                         says::volumeVoxelsNotThere(std::filesystem::path(source.path).filename().string()));
    }
    const auto stream = ByteStream::open(source);
    if (!stream) {
        return source.path == stored.path
                   ? stream.error()
                   : fileError(stored.path, says::volumeVoxelFileNotRead(stream.error().message));
    }
    if (isHeaderAmongVoxels(stored)) {
        return fileError(stored.path, says::volumeVoxelsAreHeader());
    }
    const std::uint64_t needed = stored.geometry.voxelCount() * bytesOf(stored.type);
    const std::uint64_t there = stream.value().fileSize() - std::min(source.offset, stream.value().fileSize());
    if (source.packing == StreamPacking::None && there < needed + source.skip) {
        return fileError(source.path, says::volumeCutShortBy(there, needed + source.skip));
    }
    if (static_cast<double>(needed) > greatestInflation * static_cast<double>(there)) {
        return cutShort(stored);
    }
    if (2.0 * static_cast<double>(stored.geometry.voxelCount()) > 0.9 * memoryBytes()) {
        return fileError(stored.path, says::volumeLargerThanMemory());
    }
    return core::Done{};
}

core::Result<core::Volume> readVoxels(const StoredVolume& stored, const ReadObserver& observe, core::Messages& warnings)
{
    if (const auto plausible = checkVoxels(stored); !plausible) {
        return plausible.error();
    }
    return withType(stored.type, [&](auto kind) { return readAs<decltype(kind)>(stored, observe, warnings); });
}

core::Result<core::LabelVolume> readLabelVoxels(const StoredVolume& stored, const ReadObserver& observe)
{
    if (const auto plausible = checkVoxels(stored); !plausible) {
        return plausible.error();
    }
    return withType(stored.type, [&](auto kind) { return labelsAs<decltype(kind)>(stored, observe); });
}

}   // namespace angiopose::io