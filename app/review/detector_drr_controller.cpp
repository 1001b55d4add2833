#include "app/review/detector_drr_controller.h"

#include "app/preferences/settings.h"
#include "core/registration/picture/drr.h"
#include "ui/actions/window_actions.h"
#include "ui/views/tree_view.h"

#include <algorithm>

namespace angiopose::app {
namespace {

using ui::Command;

constexpr int maxSidePx = 256;   // low resolution suffices, because the detector is a small part of the view

/// Computes DRRs of the scan; the first call prepares the data. Not thread-safe: only one worker may use it at a time.
class Source {
public:
    Source(std::shared_ptr<const core::Volume> scan, const core::ProjectionCamera& camera)
        : scan_(std::move(scan)), camera_(camera)
    {
    }

    /// Returns the DRR as on a C-arm monitor, with dense structures dark.
    core::ImageF from(const core::RigidTransform& cameraFromPatient)
    {
        if (!body_) {
            body_.emplace(*scan_, camera_, maxSidePx);
            scan_.reset();
        }
        core::ImageF picture = body_->from(cameraFromPatient);
        std::ranges::transform(picture.pixels, picture.pixels.begin(), [](float dense) { return -dense; });
        return picture;
    }

private:
    std::shared_ptr<const core::Volume> scan_;
    core::ProjectionCamera camera_;
    std::optional<core::BodyDrr> body_;
};

}   // namespace

DetectorDrrController::DetectorDrrController(const CaseDocument& document, const ViewSync& sync, const Ui& ui,
                                             QObject* parent)
    : QObject(parent), document_(document), ui_(ui), job_([this](const core::ImageF& picture) { show(picture); })
{
    QAction* scanAction = ui.actions[Command::ScanOnDetector];
    scanAction->setChecked(settings::scanOnDetector.read());
    connect(scanAction, &QAction::toggled, this, [this](bool on) {
        settings::scanOnDetector.write(on);
        updateFromDocument();
    });
    connect(&document, &CaseDocument::changed, this, &DetectorDrrController::updateFromDocument);
    connect(&sync, &ViewSync::poseShown, this,
            [this](const core::RigidTransform& cameraFromPatient) { job_.request(cameraFromPatient); });
    updateFromDocument();
}

void DetectorDrrController::updateFromDocument()
{
    const core::Case& current = document_.current();
    const auto known = core::cameraOf(current.shown());
    const bool isPossible = current.vessels.scan && known;
    QAction* scanAction = ui_.actions[Command::ScanOnDetector];
    scanAction->setEnabled(isPossible);
    const bool isOn = isPossible && scanAction->isChecked();
    const auto scan = isOn ? current.vessels.scan : nullptr;
    const auto camera = isOn ? std::optional(known.value()) : std::nullopt;
    if (scan == scan_ && camera == camera_) {
        return;
    }
    scan_ = scan;
    camera_ = camera;
    if (!isOn) {
        job_.clear();
        show({});
        return;
    }
    job_.setWork([source = std::make_shared<Source>(scan, *camera)](const core::RigidTransform& cameraFromPatient,
                                                                    JobLink<double>&) -> core::Result<core::ImageF> {
        return source->from(cameraFromPatient);
    });
    job_.request(current.shown().cameraFromPatient);
}

void DetectorDrrController::show(const core::ImageF& drr)
{
    ui_.treeView.scene().setDetectorImage(drr);
    ui_.treeView.requestRender();
}

}   // namespace angiopose::app
