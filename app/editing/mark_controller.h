#pragma once

#include "app/document/case_document.h"
#include "app/showing/pose_preview.h"
#include "app/showing/view_sync.h"
#include "core/measuring/target_points.h"
#include "ui/panels/mark_panel.h"
#include "ui/views/tools/mark_tool.h"
#include "ui/words/retranslation.h"

#include <QTimer>

#include <array>
#include <set>

namespace angiopose::ui {
class AngiogramView;
class SliceModel;
class TreeView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Manages target points and rings on the vessels, their positions in the image, and arrows and text annotations. The
/// user sets them by clicks in the image, the 3-D view and slices; the list shows the errors and lets the user rename,
/// move and remove entries. Each change is one undo step. The errors follow the poses on screen.
class MarkController : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::MarkPanel& panel;
        ui::AngiogramView& view;
        ui::TreeView& treeView;
        ui::SliceModel& slices;
    };
    MarkController(CaseDocument& document, const ViewSync& sync, const PosePreview& preview, const Ui& ui,
                   QObject* parent = nullptr);

    void pickPoint(const Eigen::Vector3d&
                       pointInPatient);   ///< handles a pick in the 3-D view or a slice, in target-point or ring mode

signals:
    void refused(const QString& reason);

private:
    void connectMode(ui::MarkMode mode, QAction& action);
    void connectPanel();
    void place(ui::MarkMode mode, const Eigen::Vector2d& pixel);
    void add(core::VesselMarkKind kind, const Eigen::Vector3d& pointInPatient);
    void addObservation(const Eigen::Vector2d& pixel, std::optional<int> markId);
    void addText(const std::vector<Eigen::Vector2d>& pixels, const QString& words);
    void moveHandle(ui::MarkMode mode, std::size_t handle, const Eigen::Vector2d& pixel);
    void rename(std::size_t row, const QString& name);
    void remove(const std::set<int>& rows);
    void removeSelectedOrLast();
    void changeMarks(std::vector<core::VesselMark> marks, const ui::LocalizedText& name);
    void changeAnnotations(std::vector<core::ImageAnnotation> annotations, const ui::LocalizedText& name);
    void show();
    void showVesselMarks();
    void showHandles();
    std::optional<Eigen::Vector3d> vesselPointAt(const Eigen::Vector2d& pixel) const;
    Eigen::Vector3d toRigidPoint(const Eigen::Vector3d& drawnPoint) const;
    std::optional<int> selectedTargetPoint(const Eigen::Vector2d& pixel) const;
    std::vector<ui::MarkRow> rows() const;
    core::PoseOfView poseOf() const;
    const core::Case& current() const { return document_.current(); }
    const std::vector<core::VesselMark>& marks() const { return document_.current().vessels.marks; }

    /// Object that a handle in the image moves.
    struct Handle {
        std::size_t index = 0;   ///< index of the mark or annotation
        std::size_t point = 0;   ///< point of the annotation
    };
    CaseDocument& document_;
    const ViewSync& sync_;
    const PosePreview& preview_;
    Ui ui_;
    std::array<ui::MarkTool*, ui::markModeCount> tools_{};
    std::array<std::vector<Handle>, ui::markModeCount> handles_;
    QTimer updateTimer_;   ///< delays updates, since poses change in rapid succession
};

}   // namespace angiopose::app
