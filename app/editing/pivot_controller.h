#pragma once

#include "app/document/case_document.h"
#include "ui/views/tools/pivot_tool.h"
#include "ui/words/retranslation.h"

#include <QObject>

namespace angiopose::ui {
class AngiogramView;
class PosePanel;
class TreeView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Manages the center of manual rotation: the user picks a point on the vessels in the angiogram, in 3-D or in a slice;
/// the views mark this point until the center is reset to the centroid.
class PivotController : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::PosePanel& panel;
        ui::AngiogramView& view;
        ui::TreeView& treeView;
    };
    PivotController(CaseDocument& document, const Ui& ui, QObject* parent = nullptr);

    void pick(const Eigen::Vector3d& pointInPatient);   ///< sets the center to the nearest point on the vessels
    void pickIfActive(const Eigen::Vector3d& pointInPatient);   ///< sets the center only while the pick command is on
    void resetToCentroid();

signals:
    void reported(const QString& message);

private:
    void change(const std::optional<Eigen::Vector3d>& pivot, const ui::LocalizedText& name, const QString& note);
    void updateFromDocument();

    CaseDocument& document_;
    Ui ui_;
    ui::PivotTool* tool_;   ///< owned by the view
    std::shared_ptr<const core::VesselTree> tree_;   ///< tree that the tool shows
    std::vector<int> hidden_;   ///< branches that the tool does not show
};

}   // namespace angiopose::app
