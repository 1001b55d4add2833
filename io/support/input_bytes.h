#pragma once

#include "core/support/message.h"
#include "core/support/result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Makes the system read the first `size` bytes of a mapped file, and returns the reason on failure, for example a
/// scratched disc, a disconnected drive, or a file truncated by another program. Accessing such bytes would crash the
/// program. On Linux before 5.14, which lacks this call, always returns nullopt.
std::optional<core::Message> findReadError(const char* mapping, std::size_t size);

/// Contents of a whole file, read-only: memory-mapped, or owned if the file had to be decompressed.
class InputBytes {
public:
    InputBytes() = default;
    explicit InputBytes(std::string content) : owned_(std::move(content)) {}
    InputBytes(const char* mapping, std::size_t size) : mapping_(mapping), size_(size) {}
    InputBytes(InputBytes&& other) noexcept;
    InputBytes& operator=(InputBytes&& other) noexcept;
    ~InputBytes();

    std::string_view view() const { return mapping_ ? std::string_view(mapping_, size_) : std::string_view(owned_); }

private:
    const char* mapping_ = nullptr;
    std::size_t size_ = 0;
    std::string owned_;
};

/// Opens an input and makes the system read all of it, so that a failing drive causes an error here rather than a
/// signal in a reader. Fails, with a remedy, for a missing, unreadable or empty file, a folder, a device, a read error,
/// and a Git LFS pointer in place of the file itself.
core::Result<InputBytes> openInput(const std::string& path);

/// Opens an input like `openInput`, for callers that access only the first `startBytes`. Later bytes are not read in
/// advance; accessing them crashes the program if the drive cannot read them.
core::Result<InputBytes> openInputStart(const std::string& path);

constexpr std::size_t startBytes = std::size_t{1} << 20;

/// Returns whether the path is a folder; false if the path is inaccessible.
bool isFolder(const std::string& path);

/// Returns the lower-case extension including the dot; ".nii.gz" counts as one extension. Empty if there is none.
std::string extensionOf(const std::string& path);

/// Returns the name of a known format from the first bytes ("a NIfTI volume", "a gzip archive", …); null if the format
/// is unknown.
const core::MessageKind<0>* describeContent(std::string_view content);

}   // namespace angiopose::io
