#pragma once

#include "app/jobs/newest_job.h"
#include "core/viewing/scan/cast_scan.h"

#include <QObject>

#include <memory>

namespace angiopose::app {

enum class ScanDetail { Rough, Fine };

/// Request to render the scan: appearance, view and level of detail.
struct ScanPictureRequest {
    core::ScanRequest look;
    core::ParallelSight sight;
    ScanDetail detail = ScanDetail::Rough;
};

struct CastPicture {
    core::ParallelSight sight;
    core::Image2d<core::Rgba> pixels;
    ScanDetail detail = ScanDetail::Rough;
};

/// Prepares a scan for volume rendering and renders it off the GUI thread. Rough renderings use fewer voxels. A new
/// request replaces a fine rendering in progress but waits for a rough one, so that the display keeps updating during
/// rotation.
class ScanJob : public QObject {
    Q_OBJECT
public:
    explicit ScanJob(QObject* parent = nullptr);

    void prepare(core::VolumeToPrepare what,
                 std::optional<double> threshold);   ///< discards the previously prepared scan
    void clear();
    bool isReady() const { return ready_ != nullptr; }
    bool isHu() const;   ///< valid once the scan is ready
    Eigen::AlignedBox3d boxInPatient() const;   ///< bounding box of the prepared scan

    void request(const ScanPictureRequest& wanted);   ///< valid once the scan is ready

signals:
    void prepared();
    void failed(const core::Message& reason);   ///< emitted if there is nothing to show
    void made(const CastPicture& picture);

private:
    struct Ready;
    static core::Result<std::shared_ptr<const Ready>> madeReady(const core::VolumeToPrepare& what,
                                                                std::optional<double> threshold,
                                                                const std::function<bool()>& shouldContinue);
    static core::Result<CastPicture> cast(const Ready& ready, const ScanPictureRequest& wanted,
                                          const std::function<bool()>& shouldContinue);
    void take(const std::shared_ptr<const Ready>& ready);

    std::shared_ptr<const Ready> ready_;
    bool isFineUnderWay_ = false;
    Job<std::shared_ptr<const Ready>> preparation_;
    NewestJob<ScanPictureRequest, CastPicture> pictures_;
};

}   // namespace angiopose::app
