#pragma once

#include "app/document/case_document.h"
#include "app/editing/branch_controller.h"
#include "app/files/export_controller.h"
#include "core/measuring/branch_profile.h"

#include <QObject>

namespace angiopose::ui {
class AngiogramView;
class ProfilePanel;
class SliceModel;
class TreeView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Shows the measurements along the selected branch. The position under the mouse in the profile is marked in the image
/// and in 3-D; a click moves the slices to that position.
class ProfileController : public QObject {
    Q_OBJECT
public:
    /// Parts of the main window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::ProfilePanel& panel;
        ui::AngiogramView& view;
        ui::TreeView& treeView;
        ui::SliceModel& slices;
    };
    ProfileController(const CaseDocument& document, const BranchController& branches,
                      ExportController& exportController, const Ui& ui, QObject* parent = nullptr);

signals:
    void refused(const QString& reason);

private:
    void show();
    void showNothing();
    void point(const std::optional<Eigen::Vector3d>& pointInPatient);
    void askForTableFile();
    void askForProfileFile();
    const core::VesselBranch* selectedBranch() const;   ///< returns null unless exactly one branch is selected

    const CaseDocument& document_;
    const BranchController& branches_;
    ExportController& exportController_;
    Ui ui_;
    std::shared_ptr<const core::VesselTree> tree_;   ///< tree to which the branch in the panel belongs
    std::optional<int> shownBranchId_;
};

}   // namespace angiopose::app
