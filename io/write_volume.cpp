#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"
#include "io/volume/volume_headers.h"
#include "io/volume_file.h"

#include <zlib.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace angiopose::io {
namespace {

constexpr std::size_t chunkVoxels = std::size_t{1} << 18;

/// Passes the bytes of a voxel array to a sink in pieces.
using Bytes = std::string_view;
using Sink = std::function<core::Status(Bytes)>;
using Producer = std::function<core::Status(const Sink&)>;

/// Deflates its input into a sink.
class Packer {
public:
    /// `windowBits` as in zlib: 15 zlib, +16 gzip.
    Packer(int windowBits, Sink sink) : sink_(std::move(sink)), block_(std::size_t{256} << 10, '\0')
    {
        isReady_ = deflateInit2(&stream_, 4, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY) == Z_OK;
    }
    Packer(const Packer&) = delete;
    Packer& operator=(const Packer&) = delete;
    ~Packer() { deflateEnd(&stream_); }

    core::Status add(Bytes bytes) { return run(bytes, Z_NO_FLUSH); }
    core::Status finish() { return run({}, Z_FINISH); }

private:
    core::Status run(Bytes bytes, int flush)
    {
        if (!isReady_) {
            return core::Error(messages::volumeNoMemoryToPack());
        }
        stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
        stream_.avail_in = static_cast<uInt>(bytes.size());
        do {
            stream_.next_out = reinterpret_cast<Bytef*>(block_.data());
            stream_.avail_out = static_cast<uInt>(block_.size());
            deflate(&stream_, flush);
            if (auto written = sink_(Bytes(block_).substr(0, block_.size() - stream_.avail_out)); !written) {
                return written;
            }
        } while (stream_.avail_out == 0);
        return core::Done{};
    }

    z_stream stream_{};
    Sink sink_;
    std::string block_;
    bool isReady_ = false;
};

core::Status packInto(const Producer& produce, int windowBits, const Sink& sink)
{
    Packer packer(windowBits, sink);
    if (auto packed = produce([&](Bytes bytes) { return packer.add(bytes); }); !packed) {
        return packed;
    }
    return packer.finish();
}

template <class T>
Producer bytesOf(const std::vector<T>& voxels)
{
    return [&voxels](const Sink& sink) {
        for (std::size_t first = 0; first < voxels.size(); first += chunkVoxels) {
            const std::size_t count = std::min(chunkVoxels, voxels.size() - first);
            const Bytes bytes(reinterpret_cast<const char*>(voxels.data() + first), count * sizeof(T));
            if (auto taken = sink(bytes); !taken) {
                return taken;
            }
        }
        return core::Status(core::Done{});
    };
}

/// Passes the values themselves, converted in chunks.
template <class T>
Producer valuesOf(const core::Volume& volume)
{
    return [&volume](const Sink& sink) {
        std::vector<T> chunk;
        for (std::size_t first = 0; first < volume.voxels.size(); first += chunkVoxels) {
            chunk.clear();
            for (std::size_t i = first; i < std::min(first + chunkVoxels, volume.voxels.size()); ++i) {
                chunk.push_back(static_cast<T>(volume.value(i)));
            }
            const Bytes bytes(reinterpret_cast<const char*>(chunk.data()), chunk.size() * sizeof(T));
            if (auto taken = sink(bytes); !taken) {
                return taken;
            }
        }
        return core::Status(core::Done{});
    };
}

/// Returns true if every value is a 16-bit whole number.
bool fitsShort(const core::Volume& volume)
{
    if (volume.slope != std::floor(volume.slope) || volume.intercept != std::floor(volume.intercept)) {
        return false;
    }
    const auto [least, most] = std::minmax_element(volume.voxels.begin(), volume.voxels.end());
    const double a = volume.slope * *least + volume.intercept, b = volume.slope * *most + volume.intercept;
    return std::min(a, b) >= std::numeric_limits<std::int16_t>::min() &&
           std::max(a, b) <= std::numeric_limits<std::int16_t>::max();
}

struct Encoding {
    std::string_view nrrdType;
    std::string_view metaType;
    Producer bytes;
};

core::Status writeNrrd(const core::VolumeGeometry& geometry, const Encoding& encoding, AtomicFile& file)
{
    if (auto written = file.write(nrrdHeader(geometry, encoding.nrrdType)); !written) {
        return written;
    }
    return packInto(encoding.bytes, 15 + 16, [&](Bytes bytes) { return file.write(bytes); });
}

/// MetaImage stores the packed size before the data: compresses once to count and once to write.
core::Status writeMetaImage(const core::VolumeGeometry& geometry, const Encoding& encoding, AtomicFile& file)
{
    std::size_t packedBytes = 0;
    auto counted = packInto(encoding.bytes, 15, [&](Bytes bytes) {
        packedBytes += bytes.size();
        return core::Status(core::Done{});
    });
    if (!counted) {
        return counted;
    }
    if (auto written = file.write(metaImageHeader(geometry, encoding.metaType, packedBytes)); !written) {
        return written;
    }
    return packInto(encoding.bytes, 15, [&](Bytes bytes) { return file.write(bytes); });
}

core::Status writeNifti(const std::string& header, const Producer& bytes, bool isPacked, AtomicFile& file)
{
    const Sink toFile = [&](Bytes piece) { return file.write(piece); };
    const Producer all = [&](const Sink& sink) {
        auto written = sink(header);
        return written ? bytes(sink) : written;
    };
    return isPacked ? packInto(all, 15 + 16, toFile) : all(toFile);
}

/// Returns the problem with the volume or the file name; nullopt if it can be written.
std::optional<core::Message> findUnwritable(const core::VolumeGeometry& geometry, std::size_t voxels,
                                            const std::string& extension)
{
    if (voxels == 0 || voxels != geometry.voxelCount()) {
        return messages::volumeNothingToWrite();
    }
    const Eigen::Vector3d& size = geometry.spacingMm;
    const bool isPlaced = size.allFinite() && geometry.originInPatient.allFinite() && geometry.direction.allFinite();
    if (!isPlaced || size.minCoeff() <= 0.0) {
        return messages::volumeNoSizeToWrite(toText(size.x()) + " x " + toText(size.y()) + " x " + toText(size.z()));
    }
    const bool isNifti = extension == ".nii" || extension == ".nii.gz";
    if (!isNifti && extension != ".nrrd" && extension != ".mha") {
        return messages::volumeExtension();
    }
    return isNifti && geometry.size.maxCoeff() > std::numeric_limits<std::int16_t>::max()
               ? std::optional(messages::niftiTooLong())
               : std::nullopt;
}

core::Status write(const core::VolumeGeometry& geometry, const Encoding& encoding, const std::string& niftiHead,
                   const Producer& niftiBytes, const std::string& path)
{
    const std::string extension = extensionOf(path);
    auto created = AtomicFile::create(path);
    if (!created) {
        return created.error();
    }
    AtomicFile file = std::move(created).value();
    const auto written = extension == ".nrrd"  ? writeNrrd(geometry, encoding, file)
                         : extension == ".mha" ? writeMetaImage(geometry, encoding, file)
                                               : writeNifti(niftiHead, niftiBytes, extension == ".nii.gz", file);
    return written ? file.commit() : written;
}

}   // namespace

core::Status writeVolume(const core::Volume& volume, const std::string& path)
{
    if (const auto problem = findUnwritable(volume.geometry, volume.voxels.size(), extensionOf(path))) {
        return fileError(path, *problem);
    }
    const Encoding encoding = fitsShort(volume) ? Encoding{"short", "MET_SHORT", valuesOf<std::int16_t>(volume)}
                                                : Encoding{"float", "MET_FLOAT", valuesOf<float>(volume)};
    return write(volume.geometry, encoding, niftiHeader(volume.geometry, volume.slope, volume.intercept, false),
                 bytesOf(volume.voxels), path);
}

core::Status writeLabels(const core::LabelVolume& labels, const std::string& path)
{
    if (const auto problem = findUnwritable(labels.geometry, labels.voxels.size(), extensionOf(path))) {
        return fileError(path, *problem);
    }
    return write(labels.geometry, {"unsigned short", "MET_USHORT", bytesOf(labels.voxels)},
                 niftiHeader(labels.geometry, 1.0, 0.0, true), bytesOf(labels.voxels), path);
}

}   // namespace angiopose::io