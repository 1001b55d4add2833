#pragma once

#include "core/imaging/volume.h"
#include "core/support/message.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

enum class VoxelType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Int64, Uint64, Float32, Float64 };

constexpr std::size_t bytesOf(VoxelType type)
{
    switch (type) {
        case VoxelType::Int8:
        case VoxelType::Uint8:
            return 1;
        case VoxelType::Int16:
        case VoxelType::Uint16:
            return 2;
        case VoxelType::Int32:
        case VoxelType::Uint32:
        case VoxelType::Float32:
            return 4;
        default:
            return 8;
    }
}

constexpr std::string_view nameOf(VoxelType type)
{
    constexpr std::string_view names[] = {"int8",   "uint8", "int16",  "uint16",  "int32",
                                          "uint32", "int64", "uint64", "float32", "float64"};
    return names[static_cast<int>(type)];
}

enum class StreamPacking { None, Deflate };   ///< the latter: gzip or zlib

/// Where the voxels of a volume lie: `path` from `offset` on, unpacked, then `skip` bytes further.
struct VoxelSource {
    std::string path;
    std::uint64_t offset = 0;
    StreamPacking packing = StreamPacking::None;
    std::uint64_t skip = 0;
    bool isAtEnd = false;   ///< the voxels are the last bytes of what is unpacked, whatever precedes them
};

/// What the header of a NIfTI, NRRD or MetaImage file says about its volume: value = stored · slope + intercept.
struct StoredVolume {
    std::string path;   ///< the file that was opened, for messages
    std::string_view format;   ///< "NIfTI", …
    core::VolumeGeometry geometry;   ///< patient LPS
    VoxelType type = VoxelType::Int16;
    bool isBigEndian = false;
    double slope = 1.0;
    double intercept = 0.0;
    bool isDeclaredLabels = false;   ///< the header says that values are labels
    VoxelSource source;
    core::Messages warnings;
};

}   // namespace angiopose::io