#pragma once

#include "core/support/result.h"
#include "io/support/atomic_file.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Expected identifiers of a received object; empty identifiers match any.
struct ExpectedObject {
    std::string studyUid;
    std::string seriesUid;
    std::string sopInstance;
};

/// The location of a received object in the store.
struct StoredObject {
    enum class Kind {
        New,
        Duplicate,   ///< an identical object was already in the store
        Conflict   ///< a different object with the same UID is in the store and was not replaced
    };

    Kind kind = Kind::New;
    std::string path;
    std::string folder;   ///< folder of the object's series
    std::uint64_t bytes = 0;
};

/// An object being received into a temporary file, which is deleted unless `finish` succeeds.
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

    /// Reads the object's header and moves the file to its place in the store. Fails if the file is not DICOM or not
    /// the expected object.
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

/// Folder of complete DICOM files, arranged by study, series and instance UID.
class ObjectStore {
public:
    /// Opens the store; creates a private folder if needed and removes the leftovers of killed processes.
    static core::Result<ObjectStore> open(const std::string& root, std::uint64_t maxObjectBytes);

    const std::string& root() const { return root_; }
    core::Result<IncomingObject> begin() const { return IncomingObject::begin(root_, maxObjectBytes_); }
    std::string seriesFolder(const std::string& studyUid, const std::string& seriesUid) const;
    std::optional<std::uint64_t> storedSize(
        const ExpectedObject& object) const;   ///< nullopt if the store does not contain the object

private:
    ObjectStore(std::string root, std::uint64_t maxObjectBytes)
        : root_(std::move(root)), maxObjectBytes_(maxObjectBytes)
    {
    }

    std::string root_;
    std::uint64_t maxObjectBytes_;
};

/// Folder below the root of a store for objects that are being received.
inline constexpr std::string_view incomingFolder = ".incoming";

}   // namespace angiopose::io
