#pragma once

#include "core/imaging/volume.h"
#include "core/support/message.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace angiopose::io {

enum class VoxelType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Int64, Uint64, Float32, Float64 };

constexpr std::size_t bytesOf(VoxelType type)
{
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return sizes[static_cast<int>(type)];
}

constexpr std::string_view nameOf(VoxelType type)
{
    constexpr std::string_view names[] = {"int8",   "uint8", "int16",  "uint16",  "int32",
                                          "uint32", "int64", "uint64", "float32", "float64"};
    return names[static_cast<int>(type)];
}

/// Calls `work` with a value of the C++ type that corresponds to `type`, and returns its result.
template <class Work>
auto visitVoxelType(VoxelType type, const Work& work)
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

/// Reads the voxels of an opened volume as stored, converted to native byte order.
class VoxelReader {
public:
    VoxelReader() = default;
    VoxelReader(const VoxelReader&) = delete;
    VoxelReader& operator=(const VoxelReader&) = delete;
    virtual ~VoxelReader() = default;

    /// Fails if the file is too short for the voxels that the header declares. Reads no voxels and allocates no memory.
    virtual core::Status check() const = 0;
    /// Reads all voxels, from the first to the last.
    virtual core::Status read(char* voxels, const ReadObserver& observe) const = 0;
};

using LabelNames = std::map<int, std::string>;

/// Header of a volume file; value = stored · slope + intercept.
struct StoredVolume {
    std::string path;   ///< path of the opened file, for messages
    std::string format;   ///< format name, for example "NIfTI-1"
    core::VolumeGeometry geometry;   ///< voxel grid in patient LPS
    VoxelType type = VoxelType::Int16;
    double slope = 1.0;
    double intercept = 0.0;
    bool isDeclaredLabelMap = false;   ///< whether the header declares the values to be labels
    LabelNames labelNames;   ///< label names from the header, if any
    core::Messages warnings;
    std::shared_ptr<const VoxelReader> voxels;
};

}   // namespace angiopose::io
