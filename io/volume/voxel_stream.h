#pragma once

#include "io/volume/stored_volume.h"

#include <optional>

namespace angiopose::io {

/// Where voxels lie: in `path` from `offset` on, unpacked when that is gzip or zlib, `skip` bytes further.
struct VoxelSource {
    std::string path;
    std::uint64_t offset = 0;
    bool isPacked = false;
    std::uint64_t skip = 0;
    bool isAtEnd = false;   ///< the voxels are the last bytes of what is unpacked, whatever precedes them
    bool isBigEndian = false;
};

/// Reads the voxels of a volume whose header has been read, by zlib: piece by piece, so that it can report and stop.
std::shared_ptr<const VoxelReader> voxelStream(const StoredVolume& stored, const VoxelSource& source);

/// Up to `size` bytes from the start of a file, unpacked when it is gzip; fewer where it ends or is damaged.
std::string headOf(const std::string& path, std::size_t size);

}   // namespace angiopose::io
