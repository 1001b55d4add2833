#pragma once

#include "io/archive/model/query.h"
#include "io/archive/store/object_store.h"

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace angiopose::io {

/// What a store may hold, and what is done about more.
struct StoreLimit {
    enum class WhenFull { DropOldest, Refuse };

    std::uint64_t maxBytes = 0;   ///< 0: as much as the disk takes
    WhenFull whenFull = WhenFull::DropOldest;
};

/// Objects that come one after another into a store: counted, told of, within its limit. One thread may take them while
/// another asks how far it is.
class Arrivals {
public:
    using Reported = std::function<void(const StoredObject&)>;

    Arrivals(const ObjectStore& store, const StoreLimit& limit, TransferReport& report, const ArchiveObserver& observe);

    const ObjectStore& store() const { return *store_; }

    /// Asked for whatever is kept or there already.
    void tell(Reported reported) { reported_ = std::move(reported); }

    /// Asked for what `warn` and `miss` note, as it happens.
    using Heard = std::function<void(const core::Message&)>;
    void tellProblems(Heard heard) { heard_ = std::move(heard); }

    /// Of the whole that is awaited, this much was there before.
    void addKnown(std::size_t objects);

    core::Result<IncomingObject> begin() const { return store_->begin(); }
    /// Writes a piece, and counts it.
    core::Status write(IncomingObject& object, std::string_view piece);

    enum class Fate { Kept, Differs, Refused };
    /// Puts the object in its place. What is wrong with it alone is noted; fails where nothing more can be taken.
    core::Result<Fate> take(IncomingObject object, const ExpectedObject& expected);

    /// An object of the awaited ones did not come.
    void miss(const core::Message& why);

    /// What is worth knowing, though no object is missing for it.
    void warn(const core::Message& what);

    bool isStopRequested() const;
    std::uint64_t bytesSoFar() const { return bytes_; }

private:
    void hear(const core::Message& what) const;
    core::Status makeRoom(const StoredObject& stored);
    core::Status count(const StoredObject& stored);

    const ObjectStore* store_;
    StoreLimit limit_;
    TransferReport* report_;
    const ArchiveObserver* observe_;
    Reported reported_;
    Heard heard_;
    std::atomic<std::uint64_t> bytes_ = 0;   ///< of whole and begun objects; asked by another thread
    std::uint64_t held_ = 0;   ///< by the store
    mutable std::mutex reporting_;   ///< around the report
};

/// The way to the objects of an archive, whatever language it speaks.
class SeriesSource {
public:
    virtual ~SeriesSource() = default;

    virtual core::Result<std::vector<std::string>> seriesOf(const std::string& studyUid) = 0;
    virtual core::Result<std::vector<ArchiveObject>> objectsOf(const std::string& studyUid,
                                                               const std::string& seriesUid) = 0;

    /// All objects of a series, into their places. What single objects lack is noted there.
    virtual core::Status fetch(const std::string& studyUid, const std::string& seriesUid,
                               const std::vector<ArchiveObject>& objects, Arrivals& arrivals) = 0;
};

}   // namespace angiopose::io
