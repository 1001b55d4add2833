#pragma once

#include "core/support/result.h"
#include "io/support/atomic_file.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// The identifiers expected of a received object; empty ones match anything.
struct ExpectedObject {
    std::string studyUid;
    std::string seriesUid;
    std::string sopInstance;
};

/// The location of a received object in the store.
struct StoredObject {
    enum class Kind {
        New,
        Duplicate,   ///< identical content was already there
        Conflict   ///< a different object of the same UID is there and is not replaced
    };

    Kind kind = Kind::New;
    std::string path;
    std::string folder;   ///< folder of its series
    std::uint64_t bytes = 0;
};

/// An object during reception, under a temporary name; deleted unless `finish` succeeds.
class IncomingObject {
public:
    /// Creates a temporary file below `root`, the store's folder.
    static core::Result<IncomingObject> begin(const std::string& root, std::uint64_t maxBytes);
    IncomingObject(IncomingObject&&) noexcept = default;
    IncomingObject& operator=(IncomingObject&&) noexcept = default;
    ~IncomingObject() = default;

    /// Appends bytes; fails if the object exceeds the size limit (see `isTooLarge`) or the disk is full.
    core::Status write(std::string_view bytes);
    bool isTooLarge() const { return isTooLarge_; }

    /// Reads the object's header and moves the file to its place. Fails if it is not a DICOM object or not the expected
    /// one.
    core::Result<StoredObject> finish(const ExpectedObject& expected) &&;

private:
    IncomingObject(std::string root, std::string temporary, AtomicFile file, std::uint64_t maxBytes);

    std::string root_;
    std::string temporary_;
    AtomicFile file_;
    std::uint64_t maxBytes_;
    std::uint64_t bytes_ = 0;
    bool isTooLarge_ = false;
};

/// A folder of complete DICOM files by study, series and object UID.
class ObjectStore {
public:
    /// Opens the store; creates a private folder if needed and removes leftovers of a killed program.
    static core::Result<ObjectStore> open(const std::string& root, std::uint64_t maxObjectBytes);

    const std::string& root() const { return root_; }
    core::Result<IncomingObject> begin() const { return IncomingObject::begin(root_, maxObjectBytes_); }
    std::string seriesFolder(const std::string& studyUid, const std::string& seriesUid) const;
    std::optional<std::uint64_t> sizeOf(const ExpectedObject& object) const;   ///< nothing: not in the store

private:
    ObjectStore(std::string root, std::uint64_t maxObjectBytes)
        : root_(std::move(root)), maxObjectBytes_(maxObjectBytes)
    {
    }

    std::string root_;
    std::uint64_t maxObjectBytes_;
};

/// Folder below the root of a store for objects during reception.
inline constexpr std::string_view incomingFolder = ".incoming";

}   // namespace angiopose::io
