#include "io/volume/byte_stream.h"

#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"

#include <zlib.h>
#include <algorithm>
#include <filesystem>
#include <fstream>

namespace angiopose::io {
namespace {

constexpr std::size_t blockSize = std::size_t{256} << 10;

}   // namespace

struct ByteStream::State {
    std::ifstream file;
    std::uint64_t fileSize = 0;
    bool isPacked = false;
    z_stream inflater{};
    bool hasInflater = false;
    bool isDamaged = false;
    std::vector<char> block;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State()
    {
        if (hasInflater) {
            inflateEnd(&inflater);
        }
    }

    /// Gives the inflater more of the file; false at its end.
    bool refill()
    {
        file.read(block.data(), static_cast<std::streamsize>(block.size()));
        inflater.next_in = reinterpret_cast<Bytef*>(block.data());
        inflater.avail_in = static_cast<uInt>(file.gcount());
        return inflater.avail_in > 0;
    }

    std::size_t inflateSome(char* out, std::size_t size)
    {
        inflater.next_out = reinterpret_cast<Bytef*>(out);
        inflater.avail_out = static_cast<uInt>(std::min(size, std::size_t{1} << 30));
        const uInt wanted = inflater.avail_out;
        while (inflater.avail_out > 0 && !isDamaged && (inflater.avail_in > 0 || refill())) {
            const int status = inflate(&inflater, Z_NO_FLUSH);
            if (status == Z_STREAM_END) {   // another archive may follow: parallel packers write several
                isDamaged = (inflater.avail_in == 0 && !refill()) || inflateReset(&inflater) != Z_OK;
            } else {
                isDamaged = status != Z_OK && status != Z_BUF_ERROR;
            }
        }
        return wanted - inflater.avail_out;
    }
};

ByteStream::ByteStream(std::unique_ptr<State> state) : state_(std::move(state)) {}
ByteStream::ByteStream(ByteStream&&) noexcept = default;
ByteStream& ByteStream::operator=(ByteStream&&) noexcept = default;
ByteStream::~ByteStream() = default;

core::Result<ByteStream> ByteStream::open(const VoxelSource& source)
{
    if (const auto input = openInput(source.path); !input) {
        return input.error();
    }
    auto state = std::make_unique<State>();
    std::error_code failed;
    state->fileSize = std::filesystem::file_size(source.path, failed);
    state->file.open(source.path, std::ios::binary);
    state->file.seekg(static_cast<std::streamoff>(source.offset));
    if (failed || !state->file) {
        return fileError(source.path, says::fileNotReadAtAll());
    }
    state->isPacked = source.packing != StreamPacking::None;
    if (state->isPacked) {
        state->hasInflater = inflateInit2(&state->inflater, 15 + 32) == Z_OK;   // gzip or zlib, by what is there
        state->isDamaged = !state->hasInflater;
        state->block.resize(blockSize);
    }
    return ByteStream(std::move(state));
}

std::size_t ByteStream::readSome(char* out, std::size_t size)
{
    if (state_->isPacked) {
        return state_->inflateSome(out, size);
    }
    state_->file.read(out, static_cast<std::streamsize>(size));
    return static_cast<std::size_t>(state_->file.gcount());
}

bool ByteStream::read(char* out, std::size_t size)
{
    while (size > 0) {
        const std::size_t got = readSome(out, size);
        if (got == 0) {
            return false;
        }
        out += got;
        size -= got;
    }
    return true;
}

bool ByteStream::skip(std::uint64_t size)
{
    std::vector<char> sink(static_cast<std::size_t>(std::min<std::uint64_t>(size, blockSize)));
    while (size > 0) {
        const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(size, sink.size()));
        if (!read(sink.data(), part)) {
            return false;
        }
        size -= part;
    }
    return true;
}

std::uint64_t ByteStream::drain()
{
    std::vector<char> sink(blockSize);
    std::uint64_t total = 0;
    while (const std::size_t got = readSome(sink.data(), sink.size())) {
        total += got;
    }
    return total;
}

std::uint64_t ByteStream::fileSize() const
{
    return state_->fileSize;
}

}   // namespace angiopose::io