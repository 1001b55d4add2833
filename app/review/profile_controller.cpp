#include "app/review/profile_controller.h"

#include "io/branch_table.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/profile_panel.h"
#include "ui/plots/profile_plot.h"
#include "ui/slices/slice_model.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"
#include "ui/words/message_text.h"
#include "ui/words/retranslation.h"

namespace angiopose::app {

ProfileController::ProfileController(const CaseDocument& document, const BranchController& branches,
                                     ExportController& exportController, const Ui& ui, QObject* parent)
    : QObject(parent), document_(document), branches_(branches), exportController_(exportController), ui_(ui)
{
    const auto showIfOther = [this] {
        const core::VesselBranch* branch = selectedBranch();
        const std::optional<int> wanted = branch ? std::optional(branch->id) : std::nullopt;
        if (wanted != shownBranchId_ || tree_ != document_.current().vessels.tree) {
            show();
        }
    };
    connect(&branches_, &BranchController::marksChanged, this, showIfOther);
    connect(&document_, &CaseDocument::changed, this, showIfOther);
    const ui::ProfilePlot& plot = ui_.panel.plot();
    connect(&plot, &ui::ProfilePlot::pointerMoved, this, &ProfileController::point);
    connect(&plot, &ui::ProfilePlot::positionClicked, this,
            [this](const Eigen::Vector3d& place) { ui_.slices.setCrosshair(place); });
    connect(&ui_.panel, &ui::ProfilePanel::tableExportRequested, ui_.actions[ui::Command::ExportBranches],
            &QAction::trigger);
    connect(ui_.actions[ui::Command::ExportBranches], &QAction::triggered, this, &ProfileController::askForTableFile);
    connect(&ui_.panel, &ui::ProfilePanel::profileExportRequested, this, &ProfileController::askForProfileFile);
    ui::keepTranslated(this, [this] { show(); });
}

const core::VesselBranch* ProfileController::selectedBranch() const
{
    const auto& tree = document_.current().vessels.tree;
    const std::set<int>& selected = branches_.marks().selected;
    return tree && selected.size() == 1 ? tree->find(*selected.begin()) : nullptr;
}

void ProfileController::show()
{
    tree_ = document_.current().vessels.tree;
    point(std::nullopt);
    const core::VesselBranch* branch = selectedBranch();
    shownBranchId_ = branch ? std::optional(branch->id) : std::nullopt;
    if (!branch) {
        ui_.panel.showNothing(tree_ ? tr("Select a branch in the list or in a view.") : QString(), tree_ != nullptr);
        return;
    }
    if (const auto profile = core::measureProfile(*branch)) {
        ui_.panel.showProfile(*branch, profile.value());
    } else {
        ui_.panel.showNothing(ui::messageText(profile.error().message), true);
    }
}

void ProfileController::point(const std::optional<Eigen::Vector3d>& pointInPatient)
{
    ui_.view.setCrosshair({std::nullopt, pointInPatient});
    ui_.treeView.setPointedPosition(pointInPatient);
}

void ProfileController::askForTableFile()
{
    if (!document_.current().vessels.tree) {
        emit refused(tr("Open the vessels first."));
        return;
    }
    exportController_.askForFile(
        {tr("Export branch measurements"), tr("Tables (*.csv)"), QStringLiteral("branches.csv")},
        [tree = document_.current().vessels.tree](const QString& path) {
            return io::writeBranchTable(*tree, path.toStdString());
        });
}

void ProfileController::askForProfileFile()
{
    const core::VesselBranch* branch = selectedBranch();
    if (!branch) {
        return;
    }
    exportController_.askForFile({tr("Export profile"), tr("Tables (*.csv)"), QStringLiteral("profile.csv")},
                                 [branch = *branch](const QString& path) -> core::Status {
                                     const auto profile = core::measureProfile(branch);
                                     return profile ? io::writeProfile(profile.value(), path.toStdString())
                                                    : core::Status(profile.error());
                                 });
}

}   // namespace angiopose::app
