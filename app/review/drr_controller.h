#pragma once

#include "app/jobs/drr_job.h"
#include "app/registration/target_provider.h"
#include "app/review/overlay_style_controller.h"
#include "app/showing/view_sync.h"

#include <QObject>

namespace angiopose::ui {
class AngiogramView;
class BottomStrip;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Shows a DRR of the vessels over the angiogram and updates it whenever the pose changes.
class DrrController : public QObject {
    Q_OBJECT
public:
    /// Objects that the controller works with.
    struct Parts {
        const CaseDocument& document;
        const TargetProvider& target;
        const ViewSync& sync;
        const OverlayStyleController& overlayStyle;
        ui::AngiogramView& view;
        ui::BottomStrip& strip;
    };
    explicit DrrController(const Parts& parts, QObject* parent = nullptr);

private:
    void setEnabled(bool enabled);
    void updateFromDocument();
    void clear();   ///< releases all data of the case, which may be closed
    void show(const core::ImageF& picture);

    Parts parts_;
    DrrJob job_;
    bool isEnabled_ = false;
    bool isReady_ = false;   ///< true if the job holds the inputs described by the members below
    std::shared_ptr<const core::VesselTree> tree_;
    std::shared_ptr<const core::Volume> volume_;
    std::optional<core::ProjectionCamera> camera_;
    std::vector<int> excluded_;
};

}   // namespace angiopose::app
