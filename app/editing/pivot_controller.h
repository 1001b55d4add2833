#pragma once

#include "app/document/case_document.h"
#include "ui/views/tools/pivot_tool.h"
#include "ui/words/spoken.h"

#include <QObject>

namespace angiopose::ui {
class AngiogramView;
class PosePanel;
class TreeView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// The place on the vessels that they turn about by hand: picked in the angiogram, in 3-D or in a slice, marked there
/// until the centroid is wanted again.
class PivotController : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::PosePanel& panel;
        ui::AngiogramView& view;
        ui::TreeView& treeView;
    };
    PivotController(CaseDocument& document, const Ui& ui, QObject* parent = nullptr);

    void pick(const Eigen::Vector3d& pointInPatient);   ///< the place on the vessels nearest to it
    void pickIfWanted(const Eigen::Vector3d& pointInPatient);   ///< while the command to pick is on
    void backToCentroid();

signals:
    void reported(const QString& what);

private:
    void change(const std::optional<Eigen::Vector3d>& pivot, const ui::Words& name, const QString& note);
    void followDocument();

    CaseDocument& document_;
    Ui ui_;
    ui::PivotTool* tool_;   ///< owned by the view
    std::shared_ptr<const core::VesselTree> tree_;   ///< shown by the tool,
    std::vector<int> hidden_;   ///< without these branches
};

}   // namespace angiopose::app