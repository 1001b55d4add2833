#include "io/archive/store/arrivals.h"

#include "io/archive/store/cache.h"
#include "io/messages/messages.h"

#include <filesystem>

namespace angiopose::io {
namespace {

std::uint64_t heldBy(const ObjectStore& store)
{
    std::uint64_t held = 0;
    for (const CachedSeries& series : cachedSeries(store.root())) {
        held += series.bytes;
    }
    return held;
}

/// Whether an error concerns only the object and not the folder in which it is stored.
bool isAboutObject(const core::Error& error)
{
    return error.message.is(messages::archiveObjectUnreadable) || error.message.is(messages::archiveObjectForeign);
}

}   // namespace

Arrivals::Arrivals(const ObjectStore& store, const StoreLimit& limit, TransferReport& report,
                   const ArchiveObserver& observe)
    : store_(&store), limit_(limit), report_(&report), observe_(&observe), held_(limit.maxBytes > 0 ? heldBy(store) : 0)
{
}

void Arrivals::addKnown(std::size_t objects)
{
    const std::lock_guard lock(reporting_);
    report_->duplicates += objects;
}

core::Status Arrivals::write(IncomingObject& object, std::string_view piece)
{
    bytes_ += piece.size();
    return object.write(piece);
}

core::Status Arrivals::makeRoom(const StoredObject& stored)
{
    held_ += stored.bytes;
    if (limit_.maxBytes == 0 || held_ <= limit_.maxBytes) {
        return core::Done{};
    }
    if (limit_.whenFull == StoreLimit::WhenFull::DropOldest) {
        held_ = shrinkCache(store_->root(), limit_.maxBytes, stored.folder);
    }
    if (held_ <= limit_.maxBytes) {
        return core::Done{};
    }
    std::error_code failed;
    std::filesystem::remove(stored.path, failed);
    held_ -= stored.bytes;
    return core::Error(messages::archiveCacheTooSmall(sizeText(limit_.maxBytes)).about(store_->root()));
}

core::Result<Arrivals::Fate> Arrivals::take(IncomingObject object, const ExpectedObject& expected)
{
    auto finished = std::move(object).finish(expected);
    if (!finished) {
        if (!isAboutObject(finished.error())) {
            return finished.error();
        }
        miss(finished.error().message);
        return Fate::Refused;
    }
    const StoredObject& stored = finished.value();
    if (stored.kind == StoredObject::Kind::Conflict) {
        miss(messages::archiveObjectDiffers(std::filesystem::path(stored.path).stem().string()));
        return Fate::Differs;
    }
    if (auto counted = count(stored); !counted) {
        return counted.error();
    }
    if (reported_) {
        reported_(stored);
    }
    return Fate::Kept;
}

core::Status Arrivals::count(const StoredObject& stored)
{
    if (stored.kind == StoredObject::Kind::New) {
        if (auto room = makeRoom(stored); !room) {
            return room;
        }
    }
    const std::lock_guard lock(reporting_);
    if (stored.kind == StoredObject::Kind::Duplicate) {
        ++report_->duplicates;
    } else {
        ++report_->transferred;
        report_->bytes += stored.bytes;
    }
    return core::Done{};
}

void Arrivals::hear(const core::Message& what) const
{
    if (heard_) {
        heard_(what);
    }
}

void Arrivals::miss(const core::Message& why)
{
    {
        const std::lock_guard lock(reporting_);
        ++report_->failed;
        report_->note(why);
    }
    hear(why);
}

void Arrivals::warn(const core::Message& what)
{
    {
        const std::lock_guard lock(reporting_);
        report_->note(what);
    }
    hear(what);
}

bool Arrivals::isStopRequested() const
{
    ArchiveProgress progress;
    {
        const std::lock_guard lock(reporting_);
        progress = {report_->transferred + report_->duplicates, report_->all, bytes_};
    }
    return *observe_ && (*observe_)(progress) == core::Verdict::Stop;
}

}   // namespace angiopose::io
