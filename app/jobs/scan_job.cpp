#include "app/jobs/scan_job.h"

#include "app/jobs/freed_elsewhere.h"
#include "app/messages/messages.h"

#include <utility>

namespace angiopose::app {
namespace {

constexpr std::size_t roughVoxels = 400'000;
constexpr double fineStepShare = 0.6;   // sampling step as a fraction of the voxel size
constexpr double roughStepShare = 1.0;

}   // namespace

struct ScanJob::Ready {
    core::PreparedVolume fine;
    core::PreparedVolume rough;
    core::IntensityLevels levels;
    bool isMask = false;
};

ScanJob::ScanJob(QObject* parent)
    : QObject(parent),
      preparation_({[this](const std::shared_ptr<const Ready>& ready) { take(ready); },
                    [this](const core::Error& error) { emit failed(error.message); }}),
      pictures_([this](const CastPicture& picture) {
          isFineUnderWay_ = false;
          emit made(picture);
      })
{
}

void ScanJob::prepare(core::VolumeToPrepare what, std::optional<double> threshold)
{
    clear();
    preparation_.start([what = std::move(what), threshold](JobLink<double>& link) {
        return madeReady(what, threshold, [&link] { return link.verdict() == core::Verdict::Continue; });
    });
}

void ScanJob::clear()
{
    preparation_.drop();
    pictures_.clear();
    isFineUnderWay_ = false;
    ready_.reset();
}

core::Result<std::shared_ptr<const ScanJob::Ready>> ScanJob::madeReady(const core::VolumeToPrepare& what,
                                                                       std::optional<double> threshold,
                                                                       const std::function<bool()>& shouldContinue)
{
    auto fine = core::preparedVolume(what, shouldContinue);
    if (!fine) {
        return core::Error(messages::scanBesideVessels());
    }
    core::VolumeToPrepare again;   // the rough volume is derived from the fine one, which is already reduced
    again.scan = std::make_shared<const core::Volume>(fine->volume);
    if (fine->hasKinds) {
        auto kinds = std::make_shared<core::VoxelMask>();
        kinds->geometry = fine->volume.geometry;
        kinds->voxels = fine->kinds;
        again.mask = std::move(kinds);
    }
    again.maxVoxels = roughVoxels;
    auto rough = core::preparedVolume(again, shouldContinue);
    if (!rough) {
        return core::Error(messages::notShown());
    }
    auto ready = std::make_shared<Ready>();
    ready->isMask = what.scan == nullptr;
    ready->levels = ready->isMask ? core::IntensityLevels() : core::seenLevels(*again.scan, threshold);
    ready->fine = std::move(*fine);
    ready->rough = std::move(*rough);
    return std::shared_ptr<const Ready>(std::move(ready));
}

core::Result<CastPicture> ScanJob::cast(const Ready& ready, const ScanPictureRequest& wanted,
                                        const std::function<bool()>& shouldContinue)
{
    const bool isFine = wanted.detail == ScanDetail::Fine;
    const core::PreparedVolume& scan = isFine ? ready.fine : ready.rough;
    const core::ScanLook look =
        ready.isMask ? core::lookOfMask(wanted.look) : core::lookOf(ready.levels, wanted.look, scan.hasKinds);
    auto pixels = core::castScan(scan, look, wanted.sight, isFine ? fineStepShare : roughStepShare, shouldContinue);
    if (!pixels) {
        return core::Error(messages::notShown());   // a newer request has stopped the rendering
    }
    return CastPicture{wanted.sight, std::move(*pixels), wanted.detail};
}

void ScanJob::take(const std::shared_ptr<const Ready>& ready)
{
    ready_ = freedElsewhere(ready);
    pictures_.setWork([ready = ready_](const ScanPictureRequest& wanted, JobLink<double>& link) {
        return cast(*ready, wanted, [&link] { return link.verdict() == core::Verdict::Continue; });
    });
    emit prepared();
}

bool ScanJob::isHu() const
{
    return ready_ && ready_->levels.isHu;
}

Eigen::AlignedBox3d ScanJob::boxInPatient() const
{
    Eigen::AlignedBox3d box;
    const core::VolumeGeometry& geometry = ready_->fine.volume.geometry;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d voxel((corner & 1) * (geometry.size.x() - 1), (corner >> 1 & 1) * (geometry.size.y() - 1),
                                    (corner >> 2) * (geometry.size.z() - 1));
        box.extend(geometry.patientFromVoxel() * voxel);
    }
    return box;
}

void ScanJob::request(const ScanPictureRequest& wanted)
{
    if (!ready_) {
        return;
    }
    if (std::exchange(isFineUnderWay_, wanted.detail == ScanDetail::Fine)) {
        pictures_.requestInstead(wanted);
    } else {
        pictures_.request(wanted);
    }
}

}   // namespace angiopose::app
