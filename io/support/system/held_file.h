#pragma once

#include <string>

namespace angiopose::io {

/// An open file or folder that programs hold against each other without waiting (flock). Let go with the object.
class HeldFile {
public:
    enum class Way { Read, Write, Folder };   ///< Write: made where it is not there

    HeldFile() = default;
    /// Never follows a link, but to a folder.
    HeldFile(const std::string& path, Way way);
    HeldFile(HeldFile&& other) noexcept;
    HeldFile& operator=(HeldFile&& other) noexcept;
    ~HeldFile();

    bool isOpen() const { return value_ >= 0; }

    enum class Held { Mine, ByAnother, Impossible };   ///< impossible: drives that know no locks
    Held holdAlone() const;
    Held holdWithOthers() const;

    /// Whether it is still the one that the path leads to: another program may just have removed it.
    bool isStillAt(const std::string& path) const;

    std::string text() const;   ///< its first 512 bytes
    void setText(const std::string& text) const;   ///< nothing where the drive is full
    void close();

private:
    int value_ = -1;
};

}   // namespace angiopose::io
