#include "io/volume/voxel_stream.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"

#include <zlib.h>
#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

namespace angiopose::io {
namespace {

constexpr std::size_t streamBlock = std::size_t{1} << 20;
constexpr std::size_t niftiHeadBytes = 348;
constexpr double maxDeflateRatio = 1100.0;   // bound of the compression ratio; that of deflate is 1032

/// Bytes of a file from `offset` on, decompressed if `isCompressed` is true.
class PackedFile {
public:
    PackedFile(const std::string& path, std::uint64_t offset, bool isCompressed) : file_(path, std::ios::binary)
    {
        file_.seekg(static_cast<std::streamoff>(offset));
        isPacked_ = isCompressed && inflateInit2(&inflater_, 15 + 32) == Z_OK;   // +32 detects gzip and zlib headers
        isDamaged_ = !file_ || isCompressed != isPacked_;
        block_.resize(isCompressed ? streamBlock / 4 : 0);
    }
    PackedFile(const PackedFile&) = delete;
    PackedFile& operator=(const PackedFile&) = delete;
    ~PackedFile() { inflateEnd(&inflater_); }

    /// Reads up to `size` bytes, at most one block; returns 0 at the end of the data or at damaged data.
    std::size_t read(char* out, std::size_t size)
    {
        size = std::min(size, streamBlock);
        if (!isPacked_) {
            file_.read(out, static_cast<std::streamsize>(size));
            return static_cast<std::size_t>(file_.gcount());
        }
        inflater_.next_out = reinterpret_cast<Bytef*>(out);
        inflater_.avail_out = static_cast<uInt>(size);
        while (inflater_.avail_out > 0 && !isDamaged_ && (inflater_.avail_in > 0 || refill())) {
            const int status = inflate(&inflater_, Z_NO_FLUSH);
            if (status == Z_STREAM_END) {   // another archive may follow: parallel compressors write several
                isDamaged_ = (inflater_.avail_in == 0 && !refill()) || inflateReset(&inflater_) != Z_OK;
            } else {
                isDamaged_ = status != Z_OK && status != Z_BUF_ERROR;
            }
        }
        return size - inflater_.avail_out;
    }

    /// Returns whether a read error of the drive occurred.
    bool hasReadError() const { return file_.bad(); }

    /// Skips up to `size` bytes and returns the number of skipped bytes.
    std::uint64_t skip(std::uint64_t size)
    {
        std::vector<char> sink(streamBlock);
        std::uint64_t done = 0;
        for (std::size_t got = 1; got > 0 && done < size; done += got) {
            got = read(sink.data(), std::min<std::uint64_t>(size - done, sink.size()));
        }
        return done;
    }

private:
    bool refill()
    {
        file_.read(block_.data(), static_cast<std::streamsize>(block_.size()));
        inflater_.next_in = reinterpret_cast<Bytef*>(block_.data());
        inflater_.avail_in = static_cast<uInt>(file_.gcount());
        return inflater_.avail_in > 0;
    }

    std::ifstream file_;
    z_stream inflater_{};
    std::vector<char> block_;
    bool isPacked_ = false;
    bool isDamaged_ = false;
};

/// Returns whether the size field at the end of a gzip file (RFC 1952) shows, without decompression, that the content
/// has fewer than `bytes` bytes. Returns false if this is uncertain: if there are several gzip members, as parallel
/// compressors write them, or above 4 GiB, which the field cannot represent.
bool declaresFewerThan(std::string_view packed, std::uint64_t bytes)
{
    constexpr std::size_t minArchive = 18;   // header and trailer of an empty gzip file, bytes
    if (!packed.starts_with("\x1f\x8b\x08") || packed.size() < minArchive ||
        bytes > std::numeric_limits<std::uint32_t>::max()) {
        return false;
    }
    std::uint64_t said = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        said |= std::uint64_t{static_cast<unsigned char>(packed[packed.size() - 4 + i])} << (8 * i);
    }
    return said < bytes && packed.find("\x1f\x8b\x08", 1) == std::string_view::npos;
}

class VoxelStream : public VoxelReader {
public:
    VoxelStream(const StoredVolume& stored, VoxelSource source)
        : path_(stored.path),
          source_(std::move(source)),
          bytesPerVoxel_(bytesOf(stored.type)),
          needed_(stored.geometry.voxelCount() * bytesOf(stored.type))
    {
    }

    core::Status check() const override;
    core::Status read(char* voxels, const ReadObserver& observe) const override;

private:
    core::Error cutShort() const { return fileError(source_.path, messages::volumePackingDamaged()); }
    bool isHeaderAmongVoxels() const;
    std::unique_ptr<PackedFile> openAtVoxels() const;

    std::string path_;
    VoxelSource source_;
    std::size_t bytesPerVoxel_;
    std::uint64_t needed_;
};

/// Returns whether a detached header refers to a complete volume file without skipping that file's header, which would
/// be displayed as voxels.
bool VoxelStream::isHeaderAmongVoxels() const
{
    if (source_.path == path_ || source_.isAtEnd || source_.offset + source_.skip > 0) {
        return false;
    }
    const std::string head = decompressedStart(source_.path, niftiHeadBytes);
    const std::string_view magic = head.size() == niftiHeadBytes ? std::string_view(head).substr(344, 3) : "";
    return head.starts_with("NRRD000") || magic == "n+1" || head.substr(4, 2) == "n+";
}

core::Status VoxelStream::check() const
{
    std::error_code unknown;   // opening the file below reports any error
    if (!std::filesystem::exists(source_.path, unknown) && !unknown) {
        return fileError(path_,
                         messages::volumeVoxelsNotThere(std::filesystem::path(source_.path).filename().string()));
    }
    const auto input = openInputStart(source_.path);
    if (!input) {
        return source_.path == path_ ? input.error()
                                     : fileError(path_, messages::volumeVoxelFileNotRead(input.error().message));
    }
    if (isHeaderAmongVoxels()) {
        return fileError(path_, messages::volumeVoxelsAreHeader());
    }
    const std::uint64_t size = input.value().view().size();
    const std::uint64_t there = size - std::min(source_.offset, size);
    if (source_.isCompressed && !source_.isAtEnd &&
        declaresFewerThan(input.value().view().substr(size - there), needed_ + source_.skip)) {
        return cutShort();
    }
    if (!source_.isCompressed && there < needed_ + source_.skip) {
        return fileError(source_.path, messages::volumeCutShortBy(there, needed_ + source_.skip));
    }
    return static_cast<double>(needed_) > maxDeflateRatio * static_cast<double>(there) ? core::Status(cutShort())
                                                                                       : core::Done{};
}

std::unique_ptr<PackedFile> VoxelStream::openAtVoxels() const
{
    const auto open = [this] {
        return std::make_unique<PackedFile>(source_.path, source_.offset, source_.isCompressed);
    };
    auto file = open();
    std::uint64_t skip = source_.skip;
    if (source_.isAtEnd) {
        const std::uint64_t length = file->skip(std::numeric_limits<std::uint64_t>::max());
        if (length < needed_) {
            return nullptr;
        }
        skip = length - needed_;
        file = open();
    }
    return file->skip(skip) == skip ? std::move(file) : nullptr;
}

void turnBytes(char* values, std::size_t bytes, std::size_t bytesPerValue)
{
    for (char* value = values; value < values + bytes; value += bytesPerValue) {
        std::reverse(value, value + bytesPerValue);
    }
}

core::Status VoxelStream::read(char* voxels, const ReadObserver& observe) const
{
    const auto file = openAtVoxels();
    if (!file) {
        return cutShort();
    }
    for (std::uint64_t done = 0; done < needed_;) {
        if (isStopRequested(observe, static_cast<double>(done) / static_cast<double>(needed_))) {
            return readingCanceled(path_);
        }
        const std::size_t got = file->read(voxels + done, needed_ - done);
        if (got == 0) {
            return file->hasReadError() ? fileError(source_.path, messages::fileNotRead(std::strerror(EIO)))
                                        : cutShort();
        }
        done += got;
    }
    const bool isTurned = source_.isBigEndian != (std::endian::native == std::endian::big);
    if (isTurned && bytesPerVoxel_ > 1) {
        turnBytes(voxels, needed_, bytesPerVoxel_);
    }
    return core::Done{};
}

}   // namespace

std::shared_ptr<const VoxelReader> voxelStream(const StoredVolume& stored, const VoxelSource& source)
{
    return std::make_shared<VoxelStream>(stored, source);
}

std::string decompressedStart(const std::string& path, std::size_t size)
{
    const auto content = openInputStart(path);
    PackedFile file(path, 0, content && content.value().view().starts_with("\x1f\x8b"));
    std::string head(size, '\0');
    std::size_t done = 0;
    for (std::size_t got = 1; got > 0 && done < size; done += got) {
        got = file.read(head.data() + done, size - done);
    }
    head.resize(done);
    return head;
}

}   // namespace angiopose::io
