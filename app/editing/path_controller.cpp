#include "app/editing/path_controller.h"

#include "app/document/edit_case.h"
#include "core/vessel/add_branch.h"
#include "ui/actions/window_actions.h"
#include "ui/slices/path_tool.h"
#include "ui/slices/slice_model.h"
#include "ui/slices/tracing_panel.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

namespace angiopose::app {
namespace {

/// Returns an observer of the path search that is called several times per second and stops the search on request.
core::TracingObserver stopOf(JobLink<double>& link)
{
    return [&link](const core::TracingReport& report) { return link.tell(report.progress); };
}

}   // namespace

PathController::PathController(CaseDocument& document, const Ui& ui, QObject* parent)
    : QObject(parent),
      document_(document),
      ui_(ui),
      tool_(new ui::PathTool(ui.slices)),
      preview_([this](const core::VesselPath& path) { tool_->showPath(path.branch.pointsInPatient); }),
      job_({[this](const core::VesselPath& path) { add(path); },
            [this](const core::Error& error) { emit failed(ui::messageText(error.message)); }})
{
    QAction& action = *ui_.actions[ui::Command::TraceBetween];
    ui::bindSliceTool(action, ui_.slices, *tool_);
    ui_.panel.bindPath(action);
    connect(&action, &QAction::toggled, this, [this](bool on) {
        if (on) {
            ui_.actions[ui::Command::SlicesLarge]->setChecked(true);
        }
    });
    connect(tool_, &ui::PathTool::pathReset, this, [this] { preview_.drop(); });
    connect(tool_, &ui::PathTool::pathRequested, this, [this](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        preview_.request({from, to});
    });
    connect(tool_, &ui::PathTool::endsPicked, this, [this](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        trace({from, to});
    });
    connect(&document, &CaseDocument::changed, this, &PathController::updateFromDocument);
    updateFromDocument();
}

/// Discards paths if the scan or the case has changed.
void PathController::updateFromDocument()
{
    const auto& scan = document_.current().vessels.scan;
    ui_.actions[ui::Command::TraceBetween]->setEnabled(scan != nullptr);
    if (scan == scan_) {
        return;
    }
    scan_ = scan;
    job_.drop();
    if (!scan) {
        preview_.clear();
        ui_.actions[ui::Command::TraceBetween]->setChecked(false);
        return;
    }
    preview_.setWork([scan](const Ends& ends, JobLink<double>& link) {
        return core::traceVesselBetween(*scan, ends.from, ends.to, stopOf(link));
    });
}

void PathController::trace(const Ends& ends)
{
    job_.start([scan = scan_, ends](JobLink<double>& link) {
        return core::traceVesselBetween(*scan, ends.from, ends.to, stopOf(link));
    });
}

void PathController::add(const core::VesselPath& path)
{
    const auto& tree = document_.current().vessels.tree;
    auto added = core::attachBranch(tree ? *tree : core::VesselTree(), path.branch);
    if (!added) {
        emit failed(ui::messageText(added.error().message));
        return;
    }
    const double lengthMm = added.value().branches.back().lengthMm();
    if (!document_.push(editTree(document_, std::move(added).value(), [] { return tr("Trace one vessel"); }))) {
        return;
    }
    QStringList notes{tr("Traced: one vessel, %1 mm.").arg(ui::numberText(lengthMm, 0))};
    for (const core::Message& warning : path.warnings) {
        notes << ui::messageText(warning);
    }
    emit reported(ui::joinSentences(notes));
}

}   // namespace angiopose::app
