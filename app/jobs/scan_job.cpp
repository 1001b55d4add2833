#include "app/jobs/scan_job.h"

#include "app/jobs/free_on_worker.h"
#include "app/messages/messages.h"

#include <utility>

namespace angiopose::app {
namespace {

constexpr std::size_t roughVoxels = 400'000;
constexpr double fineStepShare = 0.6;   // sampling interval as a fraction of the voxel size
constexpr double roughStepShare = 1.0;

}   // namespace

struct ScanJob::PreparedScan {
    core::PreparedVolume fine;
    core::PreparedVolume rough;
    core::IntensityLevels levels;
    bool isMask = false;
};

ScanJob::ScanJob(QObject* parent)
    : QObject(parent),
      preparation_({[this](const std::shared_ptr<const PreparedScan>& ready) { setPrepared(ready); },
                    [this](const core::Error& error) { emit failed(error.message); }}),
      pictures_([this](const ScanRendering& picture) {
          isRenderingFine_ = false;
          emit made(picture);
      })
{
}

void ScanJob::prepare(core::VolumePreparation what, std::optional<double> threshold)
{
    clear();
    preparation_.start([what = std::move(what), threshold](JobLink<double>& link) {
        return prepareScan(what, threshold, [&link] { return link.verdict() == core::ObserverDecision::Continue; });
    });
}

void ScanJob::clear()
{
    preparation_.drop();
    pictures_.clear();
    isRenderingFine_ = false;
    preparedScan_.reset();
}

core::Result<std::shared_ptr<const ScanJob::PreparedScan>> ScanJob::prepareScan(
    const core::VolumePreparation& what, std::optional<double> threshold, const std::function<bool()>& shouldContinue)
{
    auto fine = core::prepareVolume(what, shouldContinue);
    if (!fine) {
        return core::Error(messages::scanBesideVessels());
    }
    core::VolumePreparation again;   // the rough volume is derived from the fine one, which is already reduced
    again.scan = std::make_shared<const core::Volume>(fine->volume);
    if (fine->hasVesselLabels) {
        auto kinds = std::make_shared<core::VoxelMask>();
        kinds->geometry = fine->volume.geometry;
        kinds->voxels = fine->kinds;
        again.mask = std::move(kinds);
    }
    again.maxVoxels = roughVoxels;
    auto rough = core::prepareVolume(again, shouldContinue);
    if (!rough) {
        return core::Error(messages::notShown());
    }
    auto ready = std::make_shared<PreparedScan>();
    ready->isMask = what.scan == nullptr;
    ready->levels = ready->isMask ? core::IntensityLevels() : core::estimateLevels(*again.scan, threshold);
    ready->fine = std::move(*fine);
    ready->rough = std::move(*rough);
    return std::shared_ptr<const PreparedScan>(std::move(ready));
}

core::Result<ScanRendering> ScanJob::render(const PreparedScan& ready, const ScanRenderRequest& wanted,
                                            const std::function<bool()>& shouldContinue)
{
    const bool isFine = wanted.detail == ScanDetail::Fine;
    const core::PreparedVolume& scan = isFine ? ready.fine : ready.rough;
    const core::ScanAppearance look = ready.isMask
                                          ? core::maskAppearance(wanted.look)
                                          : core::appearanceFor(ready.levels, wanted.look, scan.hasVesselLabels);
    auto pixels = core::renderScan(scan, look, wanted.sight, isFine ? fineStepShare : roughStepShare, shouldContinue);
    if (!pixels) {
        return core::Error(messages::notShown());   // a newer request has stopped the rendering
    }
    return ScanRendering{wanted.sight, std::move(*pixels), wanted.detail};
}

void ScanJob::setPrepared(const std::shared_ptr<const PreparedScan>& ready)
{
    preparedScan_ = freeOnWorker(ready);
    pictures_.setWork([ready = preparedScan_](const ScanRenderRequest& wanted, JobLink<double>& link) {
        return render(*ready, wanted, [&link] { return link.verdict() == core::ObserverDecision::Continue; });
    });
    emit prepared();
}

bool ScanJob::isHu() const
{
    return preparedScan_ && preparedScan_->levels.isHu;
}

Eigen::AlignedBox3d ScanJob::boxInPatient() const
{
    Eigen::AlignedBox3d box;
    const core::VolumeGeometry& geometry = preparedScan_->fine.volume.geometry;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d voxel((corner & 1) * (geometry.size.x() - 1), (corner >> 1 & 1) * (geometry.size.y() - 1),
                                    (corner >> 2) * (geometry.size.z() - 1));
        box.extend(geometry.patientFromVoxel() * voxel);
    }
    return box;
}

void ScanJob::request(const ScanRenderRequest& wanted)
{
    if (!preparedScan_) {
        return;
    }
    if (std::exchange(isRenderingFine_, wanted.detail == ScanDetail::Fine)) {
        pictures_.replaceWith(wanted);
    } else {
        pictures_.request(wanted);
    }
}

}   // namespace angiopose::app
