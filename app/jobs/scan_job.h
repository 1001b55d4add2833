#pragma once

#include "app/jobs/newest_job.h"
#include "core/viewing/scan/render_scan.h"

#include <QObject>

#include <memory>

namespace angiopose::app {

enum class ScanDetail { Rough, Fine };

/// Request to render the scan: its appearance, the view and the level of detail.
struct ScanRenderRequest {
    core::AppearanceOptions appearance;
    core::ParallelProjection projection;
    ScanDetail detail = ScanDetail::Rough;
};

struct ScanRendering {
    core::ParallelProjection projection;
    core::Image2d<core::Rgba> pixels;
    ScanDetail detail = ScanDetail::Rough;
};

/// Prepares a scan for volume rendering and renders it off the GUI thread. Rough renderings use fewer voxels. A new
/// request replaces a fine rendering in progress but waits for a rough one, so that the display is updated during
/// rotation.
class ScanJob : public QObject {
    Q_OBJECT
public:
    explicit ScanJob(QObject* parent = nullptr);

    void prepare(core::VolumePreparation what,
                 std::optional<double> threshold);   ///< discards the previously prepared scan
    void clear();
    bool isReady() const { return preparedScan_ != nullptr; }
    bool isHu() const;   ///< returns whether the values are in HU; valid only after the scan is ready
    Eigen::AlignedBox3d boxInPatient() const;   ///< bounding box of the prepared scan

    void request(const ScanRenderRequest& renderRequest);   ///< may be called only after the scan is ready

signals:
    void prepared();
    void failed(const core::Message& reason);   ///< emitted if there is nothing to show
    void rendered(const ScanRendering& picture);

private:
    struct PreparedScan;
    static core::Result<std::shared_ptr<const PreparedScan>> prepareScan(const core::VolumePreparation& what,
                                                                         std::optional<double> threshold,
                                                                         const std::function<bool()>& shouldContinue);
    static core::Result<ScanRendering> render(const PreparedScan& preparedScan, const ScanRenderRequest& renderRequest,
                                              const std::function<bool()>& shouldContinue);
    void setPrepared(const std::shared_ptr<const PreparedScan>& preparedScan);

    std::shared_ptr<const PreparedScan> preparedScan_;
    bool isRenderingFine_ = false;
    Job<std::shared_ptr<const PreparedScan>> preparation_;
    NewestJob<ScanRenderRequest, ScanRendering> renderings_;
};

}   // namespace angiopose::app
