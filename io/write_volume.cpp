#include "core/imaging/volume.h"
#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"
#include "io/volume/volume_axes.h"
#include "io/volume_file.h"

#include <zlib.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {
namespace {

constexpr int labelIntent = 1002;

void putText(std::string& header, std::size_t offset, std::string_view text)
{
    std::copy(text.begin(), text.end(), header.begin() + static_cast<std::ptrdiff_t>(offset));
}

template <class T>
void put(std::string& header, std::size_t offset, T value)
{
    std::memcpy(header.data() + offset, &value, sizeof value);
}

std::string vectorText(const Eigen::Vector3d& vector)
{
    return "(" + toText(vector.x()) + "," + toText(vector.y()) + "," + toText(vector.z()) + ")";
}

std::string listText(const Eigen::Vector3d& vector)
{
    return " " + toText(vector.x()) + " " + toText(vector.y()) + " " + toText(vector.z());
}

/// Returns a NIfTI-1 header of 352 bytes for 16-bit voxels, unsigned if `isLabel` is true.
std::string niftiHeader(const core::VolumeGeometry& geometry, double slope, double intercept, bool isLabel)
{
    std::string header(352, '\0');
    put<std::int32_t>(header, 0, 348);
    const std::array<int, 8> dim = {3, geometry.size.x(), geometry.size.y(), geometry.size.z(), 1, 1, 1, 1};
    const Eigen::Matrix3d axes = lpsFromRas(Eigen::Matrix3d(geometry.direction));   // same conversion from LPS to RAS
    const double handedness = axes.determinant() < 0.0 ? -1.0 : 1.0;
    const std::array<double, 4> pixdim = {handedness, geometry.spacingMm.x(), geometry.spacingMm.y(),
                                          geometry.spacingMm.z()};
    for (std::size_t i = 0; i < 8; ++i) {
        put(header, 40 + 2 * i, static_cast<std::int16_t>(dim[i]));
        put(header, 76 + 4 * i, static_cast<float>(i < 4 ? pixdim[i] : 0.0));
    }
    put<std::int16_t>(header, 68, static_cast<std::int16_t>(isLabel ? labelIntent : 0));
    put<std::int16_t>(header, 70, static_cast<std::int16_t>(isLabel ? 512 : 4));
    put<std::int16_t>(header, 72, 16);
    put(header, 108, 352.0F);
    put(header, 112, static_cast<float>(slope));
    put(header, 116, static_cast<float>(intercept));
    put<std::uint8_t>(header, 123, 2);   // xyzt_units: mm
    put<std::int16_t>(header, 252, 1);
    put<std::int16_t>(header, 254, 1);
    Eigen::Matrix3d turn = axes;
    turn.col(2) *= handedness;
    Eigen::Quaterniond quaternion(turn);
    if (quaternion.w() < 0.0) {
        quaternion.coeffs() *= -1.0;
    }
    const Eigen::Vector3d origin = lpsFromRas(Eigen::Vector3d(geometry.originInPatient));
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        put(header, 256 + 4 * i, static_cast<float>(quaternion.vec()[row]));
        put(header, 268 + 4 * i, static_cast<float>(origin[row]));
        for (std::size_t k = 0; k < 4; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const double value = k < 3 ? axes(row, axis) * geometry.spacingMm[axis] : origin[row];
            put(header, 280 + 16 * i + 4 * k, static_cast<float>(value));
        }
    }
    putText(header, 344, std::string_view("n+1\0", 4));
    return header;
}

/// Returns an NRRD header for attached gzip data, little endian. `type` is "short", "unsigned short" or "float".
std::string nrrdHeader(const core::VolumeGeometry& geometry, std::string_view type)
{
    std::string header = "NRRD0004\ntype: " + std::string(type) + "\ndimension: 3\nspace: left-posterior-superior\n";
    header += "sizes: " + std::to_string(geometry.size.x()) + " " + std::to_string(geometry.size.y()) + " " +
              std::to_string(geometry.size.z()) + "\nspace directions:";
    for (int axis = 0; axis < 3; ++axis) {
        header += " " + vectorText(geometry.direction.col(axis) * geometry.spacingMm[axis]);
    }
    return header + "\nkinds: domain domain domain\nendian: little\nencoding: gzip\nspace origin: " +
           vectorText(geometry.originInPatient) + "\n\n";
}

/// Returns a MetaImage header for attached voxels compressed to `packedBytes` bytes. `type` is "MET_SHORT",
/// "MET_USHORT" or "MET_FLOAT".
std::string metaImageHeader(const core::VolumeGeometry& geometry, std::string_view type, std::size_t packedBytes)
{
    std::string header = "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n";
    header += "CompressedData = True\nCompressedDataSize = " + std::to_string(packedBytes) + "\nTransformMatrix =";
    for (int axis = 0; axis < 3; ++axis) {
        header += listText(geometry.direction.col(axis));
    }
    header += "\nOffset =" + listText(geometry.originInPatient) + "\nElementSpacing =" + listText(geometry.spacingMm);
    header += "\nDimSize = " + std::to_string(geometry.size.x()) + " " + std::to_string(geometry.size.y()) + " " +
              std::to_string(geometry.size.z());
    return header + "\nElementType = " + std::string(type) + "\nElementDataFile = LOCAL\n";
}

constexpr std::size_t chunkVoxels = std::size_t{1} << 18;

/// A `Producer` passes the bytes of a voxel array to a `Sink`, chunk by chunk.
using Bytes = std::string_view;
using Sink = std::function<core::Status(Bytes)>;
using Producer = std::function<core::Status(const Sink&)>;

/// Compresses its input (deflate) and passes the result to a sink.
class Deflater {
public:
    /// `windowBits` as in zlib: 15 for zlib format, +16 for gzip.
    Deflater(int windowBits, Sink sink) : sink_(std::move(sink)), block_(std::size_t{256} << 10, '\0')
    {
        isReady_ = deflateInit2(&stream_, 4, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY) == Z_OK;
    }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;
    ~Deflater() { deflateEnd(&stream_); }

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
    Deflater packer(windowBits, sink);
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

/// Returns a producer of the rescaled values, converted chunk by chunk.
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

/// Returns whether every value is a whole number that fits into 16 bits.
bool fitsInt16(const core::Volume& volume)
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

/// Compresses the data twice, because MetaImage stores the compressed size before the data.
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

core::Status writeNifti(const std::string& header, const Producer& bytes, bool isCompressed, AtomicFile& file)
{
    const Sink toFile = [&](Bytes piece) { return file.write(piece); };
    const Producer all = [&](const Sink& sink) {
        auto written = sink(header);
        return written ? bytes(sink) : written;
    };
    return isCompressed ? packInto(all, 15 + 16, toFile) : all(toFile);
}

/// Returns the problem with the volume or the file name; nullopt if the volume can be written.
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
    const Encoding encoding = fitsInt16(volume) ? Encoding{"short", "MET_SHORT", valuesOf<std::int16_t>(volume)}
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
