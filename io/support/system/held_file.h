#pragma once

#include <string>

namespace angiopose::io {

/// An open file or folder with a non-blocking lock between programs (flock). Released with the object.
class HeldFile {
public:
    enum class Way { Read, Write, Folder };   ///< Write: created if it does not exist

    HeldFile() = default;
    /// Opens a path; follows links only to folders.
    HeldFile(const std::string& path, Way way);
    HeldFile(HeldFile&& other) noexcept;
    HeldFile& operator=(HeldFile&& other) noexcept;
    ~HeldFile();

    bool isOpen() const { return value_ >= 0; }

    enum class Held { Mine, ByAnother, Impossible };   ///< Impossible: the drive does not support locks
    Held holdAlone() const;
    Held holdWithOthers() const;

    /// Returns whether the path still leads to this file; another program may just have removed it.
    bool isStillAt(const std::string& path) const;

    std::string text() const;   ///< its first 512 bytes
    void setText(const std::string& text) const;   ///< writes nothing if the drive is full
    void close();

private:
    int value_ = -1;
};

}   // namespace angiopose::io
