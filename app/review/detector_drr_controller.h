#pragma once

#include "app/document/case_document.h"
#include "app/jobs/newest_job.h"
#include "app/showing/view_sync.h"
#include "core/geometry/rigid_transform.h"
#include "core/imaging/image2d.h"

#include <QObject>

#include <memory>
#include <optional>

namespace angiopose::ui {
class TreeView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Shows a DRR of the scan on the detector in the 3-D view, projected from the source of the shown view, and updates it
/// whenever the pose changes.
class DetectorDrrController : public QObject {
    Q_OBJECT
public:
    /// Parts of the main window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::TreeView& treeView;
    };
    DetectorDrrController(const CaseDocument& document, const ViewSync& sync, const Ui& ui, QObject* parent = nullptr);

private:
    void updateFromDocument();
    void show(const core::ImageF& drr);

    const CaseDocument& document_;
    Ui ui_;
    std::shared_ptr<const core::Volume> scan_;   ///< scan that was passed to the job
    std::optional<core::ProjectionCamera> camera_;
    NewestJob<core::RigidTransform, core::ImageF> job_;
};

}   // namespace angiopose::app
