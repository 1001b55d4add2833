#pragma once

#include "io/archive/model/query.h"
#include "io/archive/store/object_store.h"

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace angiopose::io {

/// Size limit of a store, and the policy when the limit is reached.
struct StoreLimit {
    enum class FullStorePolicy { DeleteOldest, Refuse };

    std::uint64_t maxBytes = 0;   ///< 0 if only the disk space limits the store
    FullStorePolicy whenFull = FullStorePolicy::DeleteOldest;
};

/// Puts received objects into a store: counts the objects, reports progress and enforces the size limit. One thread may
/// add objects while another queries the progress.
class StoreWriter {
public:
    using StoredCallback = std::function<void(const StoredObject&)>;

    StoreWriter(const ObjectStore& store, const StoreLimit& limit, TransferReport& report,
                const ArchiveObserver& observe);

    const ObjectStore& store() const { return *store_; }

    /// Sets the callback for each object that was stored or already present.
    void tell(StoredCallback storedCallback) { storedCallback_ = std::move(storedCallback); }

    /// Called by `warn` and `recordMissing` immediately with each message.
    using ProblemCallback = std::function<void(const core::Message&)>;
    void setProblemCallback(ProblemCallback problemCallback) { problemCallback_ = std::move(problemCallback); }

    /// Counts expected objects that were already present before the transfer.
    void addExisting(std::size_t objects);

    core::Result<IncomingObject> begin() const { return store_->begin(); }
    /// Writes a chunk of an object and counts the bytes.
    core::Status write(IncomingObject& object, std::string_view piece);

    enum class StoreOutcome { Kept, Differs, Refused };
    /// Moves a complete object to its place in the store. Records problems of the object itself; fails only if no more
    /// objects can be stored.
    core::Result<StoreOutcome> take(IncomingObject object, const ExpectedObject& expected);

    /// Records an expected object that did not arrive.
    void recordMissing(const core::Message& reason);

    /// Records a warning; unlike `recordMissing`, does not count a missing object.
    void warn(const core::Message& problem);

    bool isStopRequested() const;
    std::uint64_t receivedBytes() const { return bytes_; }

private:
    void reportProblem(const core::Message& problem) const;
    core::Status enforceLimit(const StoredObject& stored);
    core::Status count(const StoredObject& stored);

    const ObjectStore* store_;
    StoreLimit limit_;
    TransferReport* report_;
    const ArchiveObserver* observe_;
    StoredCallback storedCallback_;
    ProblemCallback problemCallback_;
    std::atomic<std::uint64_t> bytes_ = 0;   ///< bytes of complete and partial objects; read by another thread
    std::uint64_t storedBytes_ = 0;   ///< total size of the store, bytes
    mutable std::mutex reportMutex_;   ///< protects the report
};

/// Protocol-independent access to the objects of an archive.
class SeriesSource {
public:
    virtual ~SeriesSource() = default;

    virtual core::Result<std::vector<std::string>> seriesOf(const std::string& studyUid) = 0;
    virtual core::Result<std::vector<ArchiveObject>> objectsOf(const std::string& studyUid,
                                                               const std::string& seriesUid) = 0;

    /// Fetches all objects of a series into the store. `storeWriter` records problems with individual objects.
    virtual core::Status fetch(const std::string& studyUid, const std::string& seriesUid,
                               const std::vector<ArchiveObject>& objects, StoreWriter& storeWriter) = 0;
};

}   // namespace angiopose::io
