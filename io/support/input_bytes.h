#pragma once

#include "core/support/message.h"
#include "core/support/result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Has the system read the first `size` bytes of a mapped file, and says why it cannot: a scratched disc, a drive that
/// went away, a file that another program cut short. To look at such bytes would end the program. Linux before 5.14
/// does not know the question, and nothing is said.
std::optional<core::Message> findReadError(const char* mapping, std::size_t size);

/// Content of a whole file, read-only: mapped from disk, or owned when it had to be unpacked.
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

/// Opens an input and has the system read all of it, so that a drive that cannot is told of here and not by a signal
/// in the middle of a reader. Fails, saying what to do, on a missing, unreadable or empty file, a folder, a device, a
/// read error, and on a Git LFS pointer in place of the file itself.
core::Result<InputBytes> openInput(const std::string& path);

/// As `openInput`, for whoever looks at the first `startBytes` alone: what lies behind them is not read, and to look
/// there ends the program where the drive cannot read it.
core::Result<InputBytes> openInputStart(const std::string& path);

constexpr std::size_t startBytes = std::size_t{1} << 20;

/// Also of a place that cannot be looked at: that is none.
bool isFolder(const std::string& path);

/// Lower-case extension with its dot, ".nii.gz" as one; empty when there is none.
std::string extensionOf(const std::string& path);

/// A known format by its first bytes ("a NIfTI volume", "a gzip archive", …); null when not recognised.
const core::MessageKind<0>* describeContent(std::string_view content);

}   // namespace angiopose::io
