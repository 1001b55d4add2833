#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace angiopose::io {

enum class FileKind { Missing, Unreachable, Folder, Regular, Other };

struct FileFacts {
    FileKind kind = FileKind::Missing;
    std::size_t size = 0;
    std::string problem;   ///< what the system says of an unreachable one
};

/// Looked at without opening it: to open a pipe would wait for ever.
FileFacts factsOf(const std::string& path);

/// A file that is open for reading, closed with the object. Opening a pipe does not wait for who writes to it.
class ReadHandle {
public:
    explicit ReadHandle(const std::string& path);
    ReadHandle(const ReadHandle&) = delete;
    ReadHandle& operator=(const ReadHandle&) = delete;
    ~ReadHandle();

    bool isOpen() const { return value_ >= 0; }
    bool isRegular() const { return isRegular_; }
    std::size_t size() const { return size_; }
    const std::string& problem() const { return problem_; }   ///< what the system said last

    /// How many bytes came; 0 where no more can be had: `problem` says why.
    std::size_t read(char* bytes, std::size_t most);

    /// The whole file in memory, read as it is looked at; null where that cannot be: `problem` says why.
    const char* map();

private:
    int value_ = -1;
    bool isRegular_ = false;
    std::size_t size_ = 0;
    std::string problem_;
};

/// Gives back what `ReadHandle::map` gave.
void unmap(const char* mapping, std::size_t size);

/// Has the system read the first bytes of a mapping, and tells what it says where it cannot; nothing where the system
/// does not know the question.
std::optional<std::string> faultOfMapping(const char* mapping, std::size_t size);

}   // namespace angiopose::io
