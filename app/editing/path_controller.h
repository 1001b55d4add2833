#pragma once

#include "app/document/case_document.h"
#include "app/jobs/newest_job.h"
#include "core/tracing/volume/path/vessel_path.h"
#include "ui/words/retranslation.h"

#include <QObject>

namespace angiopose::ui {
class PathTool;
class SliceModel;
class TracingPanel;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Traces one vessel of the scan between two clicks in the slices: previews the path as the mouse moves, and adds the
/// vessel to the tree as a branch in one undo step.
class PathController : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::TracingPanel& panel;
        ui::SliceModel& slices;
    };
    PathController(CaseDocument& document, const Ui& ui, QObject* parent = nullptr);

signals:
    void reported(const QString& note);
    void failed(const QString& reason);

private:
    struct Ends {
        Eigen::Vector3d from;
        Eigen::Vector3d to;
    };
    void updateFromDocument();
    void trace(const Ends& ends);
    void add(const core::VesselPath& path);

    CaseDocument& document_;
    Ui ui_;
    ui::PathTool* tool_;
    std::shared_ptr<const core::Volume> scan_;
    NewestJob<Ends, core::VesselPath> preview_;
    Job<core::VesselPath> job_;
};

}   // namespace angiopose::app
