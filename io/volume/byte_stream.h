#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <cstdio>
#include <memory>
#include <vector>

namespace angiopose::io {

/// Bytes of a file from an offset on, unpacked on the way: a few hundred kilobytes are in memory at any time.
class ByteStream {
public:
    /// Fails as `openInput` does.
    static core::Result<ByteStream> open(const VoxelSource& source);
    ByteStream(ByteStream&&) noexcept;
    ByteStream& operator=(ByteStream&&) noexcept;
    ~ByteStream();

    bool read(char* out, std::size_t size);   ///< false when fewer bytes are there, or they are damaged
    std::size_t readSome(char* out, std::size_t size);   ///< what is there, up to `size`; 0 at the end or at damage
    bool skip(std::uint64_t size);
    std::uint64_t drain();   ///< bytes that were left
    std::uint64_t fileSize() const;

private:
    struct State;
    explicit ByteStream(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}   // namespace angiopose::io