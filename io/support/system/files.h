#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace angiopose::io {

enum class FileKind { Missing, Unreachable, Folder, Regular, Other };

struct FileStatus {
    FileKind kind = FileKind::Missing;
    std::size_t size = 0;
    std::string problem;   ///< error text of the system; empty if the path is accessible
};

/// Examines a path without opening it, because opening a pipe would block forever.
FileStatus fileStatus(const std::string& path);

/// File open for reading; the destructor closes it. Opening a pipe does not wait for a writer.
class ReadHandle {
public:
    explicit ReadHandle(const std::string& path);
    ReadHandle(const ReadHandle&) = delete;
    ReadHandle& operator=(const ReadHandle&) = delete;
    ~ReadHandle();

    bool isOpen() const { return descriptor_ >= 0; }
    bool isRegular() const { return isRegular_; }
    std::size_t size() const { return size_; }
    const std::string& problem() const { return problem_; }   ///< latest error text of the system

    /// Returns the number of bytes read; 0 at the end of the file or on failure, with the reason in `problem`.
    std::size_t read(char* bytes, std::size_t maxBytes);

    /// Maps the whole file into memory, read on access; null on failure, with the reason in `problem`.
    const char* map();

private:
    int descriptor_ = -1;
    bool isRegular_ = false;
    std::size_t size_ = 0;
    std::string problem_;
};

/// Releases a mapping created by `ReadHandle::map`.
void unmap(const char* mapping, std::size_t size);

/// Makes the system read the first `size` bytes of a mapping, and returns the system's error text on failure. Returns
/// nullopt on success, and if the system lacks this call.
std::optional<std::string> findMappingFault(const char* mapping, std::size_t size);

}   // namespace angiopose::io
