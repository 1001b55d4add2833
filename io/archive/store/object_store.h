#pragma once

#include "core/support/result.h"
#include "io/support/atomic_file.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// What an object that comes is expected to be; what is empty may be anything.
struct ExpectedObject {
    std::string studyUid;
    std::string seriesUid;
    std::string sopInstance;
};

/// Where an object that came has its place.
struct StoredObject {
    enum class Kind {
        New,
        Duplicate,   ///< the very same lay there
        Conflict   ///< another one of the same UID lies there and stays
    };

    Kind kind = Kind::New;
    std::string path;
    std::string folder;   ///< of its series
    std::uint64_t bytes = 0;
};

/// An object while it comes: under a temporary name, gone again unless `finish` finds it whole.
class IncomingObject {
public:
    /// `root`: of the store.
    static core::Result<IncomingObject> begin(const std::string& root, std::uint64_t maxBytes);
    IncomingObject(IncomingObject&&) noexcept = default;
    IncomingObject& operator=(IncomingObject&&) noexcept = default;
    ~IncomingObject() = default;

    /// Fails on what is larger than allowed (see `isTooLarge`), and when the disk is full.
    core::Status write(std::string_view bytes);
    bool isTooLarge() const { return isTooLarge_; }

    /// Reads its header, and moves it to its place. Fails on what is no DICOM object, or not the expected one.
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

/// A folder of DICOM objects by study, series and object UID, in which each file is whole.
class ObjectStore {
public:
    /// Makes the folder, for its owner alone, where there is none; clears away what a killed program left in it.
    static core::Result<ObjectStore> open(const std::string& root, std::uint64_t maxObjectBytes);

    const std::string& root() const { return root_; }
    core::Result<IncomingObject> begin() const { return IncomingObject::begin(root_, maxObjectBytes_); }
    std::string seriesFolder(const std::string& studyUid, const std::string& seriesUid) const;
    std::optional<std::uint64_t> sizeOf(const ExpectedObject& object) const;   ///< nothing: it is not there

private:
    ObjectStore(std::string root, std::uint64_t maxObjectBytes)
        : root_(std::move(root)), maxObjectBytes_(maxObjectBytes)
    {
    }

    std::string root_;
    std::uint64_t maxObjectBytes_;
};

/// Where objects lie while they come, below the root of a store.
inline constexpr std::string_view incomingFolder = ".incoming";

}   // namespace angiopose::io
