#pragma once

#include <string>

namespace angiopose::io {

/// Open file or folder with a non-blocking lock between programs (flock). The destructor releases the lock.
class HeldFile {
public:
    enum class Way { Read, Write, Folder };   ///< `Write` creates the file if it does not exist

    HeldFile() = default;
    /// Opens a path; follows symbolic links only to folders.
    HeldFile(const std::string& path, Way way);
    HeldFile(HeldFile&& other) noexcept;
    HeldFile& operator=(HeldFile&& other) noexcept;
    ~HeldFile();

    bool isOpen() const { return value_ >= 0; }

    enum class Held { Mine, ByAnother, Impossible };   ///< `Impossible` means that the drive does not support locks
    Held holdAlone() const;
    Held holdWithOthers() const;

    /// Whether the path still refers to this file; another program may have just removed the file.
    bool isStillAt(const std::string& path) const;

    std::string text() const;   ///< first 512 bytes of the file
    void setText(const std::string& text) const;   ///< writes nothing if the drive is full
    void close();

private:
    int value_ = -1;
};

}   // namespace angiopose::io
