#pragma once

#include "app/jobs/newest_job.h"
#include "core/viewing/scan/cast_scan.h"

#include <QObject>

#include <memory>

namespace angiopose::app {

enum class ScanDetail { Rough, Fine };

/// How the scan is to be seen.
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

/// A scan made ready to be looked through, and pictures of it, off the window's thread. A rough picture takes a scan
/// of fewer voxels; a wanted takes the place of fine pictures under way, and waits for a rough one, so that pictures
/// come while the view turns.
class ScanJob : public QObject {
    Q_OBJECT
public:
    explicit ScanJob(QObject* parent = nullptr);

    void prepare(core::VolumeToPrepare what, std::optional<double> threshold);   ///< what was ready is let go of
    void clear();
    bool isReady() const { return ready_ != nullptr; }
    bool isHu() const;   ///< once it is ready
    Eigen::AlignedBox3d boxInPatient() const;   ///< where the scan that is ready lies

    void request(const ScanPictureRequest& wanted);   ///< once it is ready

signals:
    void prepared();
    void failed(const core::Message& reason);   ///< there is nothing to see
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
