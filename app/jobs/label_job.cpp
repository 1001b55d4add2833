#include "app/jobs/label_job.h"

#include "app/jobs/guarded.h"
#include "app/jobs/publish_outcome.h"

#include <QtConcurrentRun>

namespace angiopose::app {
namespace {

core::Result<LabelOverview> readOverview(const std::string& path, const io::ReadObserver& observe)
{
    auto read = io::readLabelOverview(path, observe);
    if (!read) {
        return read.error();
    }
    io::LabelOverview overview = std::move(read).value();
    const std::vector<int> vessels = io::vesselsByName(overview.labels);
    return LabelOverview{std::move(overview.labels),
                         {vessels.begin(), vessels.end()},
                         std::make_shared<const core::VoxelMask>(std::move(overview.rows.rows)),
                         std::move(overview.rows.middlesInPatient)};
}

}   // namespace

LabelJob::LabelJob(QObject* parent) : QObject(parent) {}

LabelJob::~LabelJob()
{
    drop();
}

void LabelJob::start(const std::string& path)
{
    using Outcome = core::Result<LabelOverview>;
    drop();
    isDropped_ = std::make_shared<std::atomic<bool>>(false);
    auto* watcher = new QFutureWatcher<Outcome>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, isDropped = isDropped_] {
        watcher->deleteLater();
        if (*isDropped) {
            return;
        }
        isDropped_.reset();
        publishOutcome(*this, watcher->result());
    });
    watcher->setFuture(QtConcurrent::run([path, isDropped = isDropped_] {
        return guarded<LabelOverview>([&] {
            return readOverview(
                path, [&isDropped](double) { return *isDropped ? core::Verdict::Stop : core::Verdict::Continue; });
        });
    }));
}

void LabelJob::drop()
{
    if (isDropped_) {
        *isDropped_ = true;
        isDropped_.reset();
    }
}

}   // namespace angiopose::app