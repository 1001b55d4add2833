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
      preparation_({[this](const std::shared_ptr<const PreparedScan>& preparedScan) { setPrepared(preparedScan); },
                    [this](const core::Error& error) { emit failed(error.message); }}),
      renderings_([this](const ScanRendering& picture) {
          isRenderingFine_ = false;
          emit rendered(picture);
      })
{
}

void ScanJob::prepare(core::VolumePreparation what, std::optional<double> threshold)
{
    clear();
    preparation_.start([what = std::move(what), threshold](JobLink<double>& link) {
        return prepareScan(what, threshold, [&link] { return link.decision() == core::ObserverDecision::Continue; });
    });
}

void ScanJob::clear()
{
    preparation_.drop();
    renderings_.clear();
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
    auto preparedScan = std::make_shared<PreparedScan>();
    preparedScan->isMask = what.scan == nullptr;
    preparedScan->levels =
        preparedScan->isMask ? core::IntensityLevels() : core::estimateLevels(*again.scan, threshold);
    preparedScan->fine = std::move(*fine);
    preparedScan->rough = std::move(*rough);
    return std::shared_ptr<const PreparedScan>(std::move(preparedScan));
}

core::Result<ScanRendering> ScanJob::render(const PreparedScan& preparedScan, const ScanRenderRequest& renderRequest,
                                            const std::function<bool()>& shouldContinue)
{
    const bool isFine = renderRequest.detail == ScanDetail::Fine;
    const core::PreparedVolume& scan = isFine ? preparedScan.fine : preparedScan.rough;
    const core::ScanAppearance appearance =
        preparedScan.isMask ? core::maskAppearance(renderRequest.appearance)
                            : core::appearanceFor(preparedScan.levels, renderRequest.appearance, scan.hasVesselLabels);
    auto pixels = core::renderScan(scan, appearance, renderRequest.projection, isFine ? fineStepShare : roughStepShare,
                                   shouldContinue);
    if (!pixels) {
        return core::Error(messages::notShown());   // a newer request has stopped the rendering
    }
    return ScanRendering{renderRequest.projection, std::move(*pixels), renderRequest.detail};
}

void ScanJob::setPrepared(const std::shared_ptr<const PreparedScan>& preparedScan)
{
    preparedScan_ = freeOnWorker(preparedScan);
    renderings_.setWork([preparedScan = preparedScan_](const ScanRenderRequest& renderRequest, JobLink<double>& link) {
        return render(*preparedScan, renderRequest,
                      [&link] { return link.decision() == core::ObserverDecision::Continue; });
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

void ScanJob::request(const ScanRenderRequest& renderRequest)
{
    if (!preparedScan_) {
        return;
    }
    if (std::exchange(isRenderingFine_, renderRequest.detail == ScanDetail::Fine)) {
        renderings_.replaceWith(renderRequest);
    } else {
        renderings_.request(renderRequest);
    }
}

}   // namespace angiopose::app
