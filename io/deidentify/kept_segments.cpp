#include "io/deidentify/kept_segments.h"

#include "io/dicom/pixel_layout.h"
#include "io/messages/says_deidentify.h"
#include "io/support/file_error.h"

namespace angiopose::io {
namespace {

constexpr std::size_t mostVoxels = std::size_t{1} << 34;   // 2 GB of bits

}   // namespace

core::Status copySegments(const DicomFile& file, const std::string& path, DicomItem& to)
{
    const auto read = pixelLayoutOf(file, path, mostVoxels);
    if (!read) {
        return read.error();
    }
    const PixelLayout& layout = read.value();
    const auto found = file.pixels.find(pixelDataTag);
    const bool isKnown = layout.samples == 1 && (layout.bitsAllocated == 1 || layout.bitsAllocated == 8);
    if (!isKnown || found == file.pixels.end() || found->second.isEncapsulated ||
        found->second.order == ByteOrder::Big) {
        return fileError(path, says::segmentationStays());
    }
    const std::size_t bits = layout.pixelsPerFrame() * static_cast<std::size_t>(layout.frames) *
                             static_cast<std::size_t>(layout.bitsAllocated);
    const std::size_t bytes = (bits + 7) / 8;
    if (found->second.bytes.size() < bytes) {
        return fileError(path, says::segmentationStays());
    }
    std::string voxels(found->second.bytes.substr(0, bytes));
    if (const std::size_t used = bits % 8; used != 0) {   // the first voxel lies in the lowest bit
        voxels.back() = static_cast<char>(static_cast<unsigned char>(voxels.back()) & ((1U << used) - 1U));
    }
    to.bytes(pixelDataTag, voxels);
    return core::Done{};
}

}   // namespace angiopose::io
