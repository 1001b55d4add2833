#pragma once

#include <string>

namespace angiopose::io {

/// Open file or folder with a non-blocking lock between programs (flock). The destructor releases the lock.
class LockableFile {
public:
    enum class OpenMode { Read, Write, Folder };   ///< `Write` creates the file if it does not exist

    LockableFile() = default;
    /// Opens a path; follows symbolic links only to folders.
    LockableFile(const std::string& path, OpenMode mode);
    LockableFile(LockableFile&& other) noexcept;
    LockableFile& operator=(LockableFile&& other) noexcept;
    ~LockableFile();

    bool isOpen() const { return descriptor_ >= 0; }

    enum class LockState {
        Acquired,
        HeldByOther,
        Impossible
    };   ///< `Impossible` means that the drive does not support locks
    LockState lockExclusive() const;
    LockState lockShared() const;

    /// Returns whether the path still refers to this file; another program may have just removed the file.
    bool isStillLinkedAt(const std::string& path) const;

    std::string text() const;   ///< first 512 bytes of the file
    void setText(const std::string& text) const;   ///< writes nothing if the drive is full
    void close();

private:
    int descriptor_ = -1;
};

}   // namespace angiopose::io
