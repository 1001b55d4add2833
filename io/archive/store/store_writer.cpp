#include "io/archive/store/store_writer.h"

#include "io/archive/store/cache.h"
#include "io/messages/messages.h"

#include <filesystem>

namespace angiopose::io {
namespace {

std::uint64_t heldBy(const ObjectStore& store)
{
    std::uint64_t held = 0;
    for (const CachedSeries& series : listCachedSeries(store.root())) {
        held += series.bytes;
    }
    return held;
}

/// Returns whether an error concerns only the object and not the folder in which it is stored.
bool isAboutObject(const core::Error& error)
{
    return error.message.is(messages::archiveObjectUnreadable) || error.message.is(messages::archiveObjectForeign);
}

}   // namespace

StoreWriter::StoreWriter(const ObjectStore& store, const StoreLimit& limit, TransferReport& report,
                         const ArchiveObserver& observe)
    : store_(&store),
      limit_(limit),
      report_(&report),
      observe_(&observe),
      storedBytes_(limit.maxBytes > 0 ? heldBy(store) : 0)
{
}

void StoreWriter::addExisting(std::size_t objects)
{
    const std::lock_guard lock(reportMutex_);
    report_->duplicates += objects;
}

core::Status StoreWriter::write(IncomingObject& object, std::string_view piece)
{
    bytes_ += piece.size();
    return object.write(piece);
}

core::Status StoreWriter::enforceLimit(const StoredObject& stored)
{
    storedBytes_ += stored.bytes;
    if (limit_.maxBytes == 0 || storedBytes_ <= limit_.maxBytes) {
        return core::Done{};
    }
    if (limit_.whenFull == StoreLimit::FullStorePolicy::DeleteOldest) {
        storedBytes_ = shrinkCache(store_->root(), limit_.maxBytes, stored.folder);
    }
    if (storedBytes_ <= limit_.maxBytes) {
        return core::Done{};
    }
    std::error_code failed;
    std::filesystem::remove(stored.path, failed);
    storedBytes_ -= stored.bytes;
    return core::Error(messages::archiveCacheTooSmall(sizeText(limit_.maxBytes)).about(store_->root()));
}

core::Result<StoreWriter::StoreOutcome> StoreWriter::take(IncomingObject object, const ExpectedObject& expected)
{
    auto finished = std::move(object).finish(expected);
    if (!finished) {
        if (!isAboutObject(finished.error())) {
            return finished.error();
        }
        recordMissing(finished.error().message);
        return StoreOutcome::Refused;
    }
    const StoredObject& stored = finished.value();
    if (stored.kind == StoredObject::Kind::Conflict) {
        recordMissing(messages::archiveObjectDiffers(std::filesystem::path(stored.path).stem().string()));
        return StoreOutcome::Differs;
    }
    if (auto counted = count(stored); !counted) {
        return counted.error();
    }
    if (storedCallback_) {
        storedCallback_(stored);
    }
    return StoreOutcome::Kept;
}

core::Status StoreWriter::count(const StoredObject& stored)
{
    if (stored.kind == StoredObject::Kind::New) {
        if (auto room = enforceLimit(stored); !room) {
            return room;
        }
    }
    const std::lock_guard lock(reportMutex_);
    if (stored.kind == StoredObject::Kind::Duplicate) {
        ++report_->duplicates;
    } else {
        ++report_->transferred;
        report_->bytes += stored.bytes;
    }
    return core::Done{};
}

void StoreWriter::reportProblem(const core::Message& problem) const
{
    if (problemCallback_) {
        problemCallback_(problem);
    }
}

void StoreWriter::recordMissing(const core::Message& reason)
{
    {
        const std::lock_guard lock(reportMutex_);
        ++report_->failed;
        report_->addProblem(reason);
    }
    reportProblem(reason);
}

void StoreWriter::warn(const core::Message& problem)
{
    {
        const std::lock_guard lock(reportMutex_);
        report_->addProblem(problem);
    }
    reportProblem(problem);
}

bool StoreWriter::isStopRequested() const
{
    ArchiveProgress progress;
    {
        const std::lock_guard lock(reportMutex_);
        progress = {report_->transferred + report_->duplicates, report_->all, bytes_};
    }
    return *observe_ && (*observe_)(progress) == core::ObserverDecision::Stop;
}

}   // namespace angiopose::io
