#pragma once

#include "io/volume/stored_volume.h"

#include <optional>

namespace angiopose::io {

/// Location of the voxels: in `path` from `offset`, decompressed if packed (gzip, zlib), after the first `skip` bytes.
struct VoxelSource {
    std::string path;
    std::uint64_t offset = 0;
    bool isCompressed = false;
    std::uint64_t skip = 0;
    bool isAtEnd = false;   ///< whether the voxels are the last bytes of the decompressed data, whatever precedes them
    bool isBigEndian = false;
};

/// Returns a reader for the voxels of a volume whose header has been read. Decompresses in blocks, so that it can
/// report progress and be canceled.
std::shared_ptr<const VoxelReader> voxelStream(const StoredVolume& stored, const VoxelSource& source);

/// Returns the first `size` bytes of a file, decompressed if it is gzip; fewer if the file is shorter or damaged.
std::string decompressedStart(const std::string& path, std::size_t size);

}   // namespace angiopose::io
