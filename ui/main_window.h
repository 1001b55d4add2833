#pragma once

#include "ui/actions/window_actions.h"
#include "ui/panels/angiogram_panel.h"
#include "ui/panels/bottom_strip.h"
#include "ui/panels/branch_panel.h"
#include "ui/panels/fault_bar.h"
#include "ui/panels/geometry_panel.h"
#include "ui/panels/header_bar.h"
#include "ui/panels/landmark_panel.h"
#include "ui/panels/mark_panel.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/patient_bar.h"
#include "ui/panels/pose_panel.h"
#include "ui/panels/profile_panel.h"
#include "ui/panels/registration_panel.h"
#include "ui/panels/result_panel.h"
#include "ui/panels/snapshot_panel.h"
#include "ui/panels/step_bar.h"
#include "ui/panels/trial_bar.h"
#include "ui/panels/view_strip.h"
#include "ui/panels/welcome_page.h"
#include "ui/places/folding_column.h"
#include "ui/slices/slice_model.h"
#include "ui/slices/tracing_panel.h"

#include <QMainWindow>

#include <optional>

class QDataStream;
class QScrollArea;
class QSplitter;
class QStackedWidget;

namespace angiopose::ui {

class AngiogramView;
class CornerViews;
class FoldingColumn;
class SideBySide;
class SlicesPage;
class TreeView;
class ViewFrame;

/// Views that can fill the window or be popped out.
enum class MovableView { Image, Corner, Slices };

/// Main window with all views and panels. Independent of the case; the owner of the window connects the two.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(QWidget* parent = nullptr);

    AngiogramView& angiogramView() { return *angiogramView_; }
    ViewStrip& views() { return *views_; }
    SideBySide& sideBySide() { return *sideBySide_; }
    TreeView& treeView() { return *treeView_; }
    SliceModel& slices() { return *slices_; }
    CornerViews& corner() { return *corner_; }
    SlicesPage& slicesPage() { return *slicesPage_; }
    TracingPanel& tracing() { return *tracing_; }
    HeaderBar& header() { return *header_; }
    StepBar& steps() { return *steps_; }
    PatientBar& patient() { return *patient_; }
    BranchPanel& branches() { return *branches_; }
    PosePanel& pose() { return *pose_; }
    AngiogramPanel& angiogramPanel() { return *angiogramPanel_; }
    GeometryPanel& geometryPanel() { return *geometry_; }
    LandmarkPanel& landmarks() { return *landmarks_; }
    MeasurePanel& measure() { return *measure_; }
    MarkPanel& marks() { return *marks_; }
    ProfilePanel& profile() { return *profile_; }
    RegistrationPanel& registration() { return *registration_; }
    ResultPanel& result() { return *result_; }
    SnapshotPanel& snapshots() { return *snapshots_; }
    TrialBar& trialBar() { return *trialBar_; }
    FaultBar& faultBar() { return *faultBar_; }
    BottomStrip& strip() { return *strip_; }
    WelcomePage& welcome() { return *welcome_; }
    WindowActions& actions() { return *actions_; }

    void showImagePage();   ///< shows the angiogram, or the CT slices if they are enlarged
    void setSlicesEnlarged(bool large);
    void showWelcomePage();
    void focusStep(Step step);   ///< shows and focuses the panel of a step

    ViewFrame& frameOf(MovableView view);
    /// Maximizes one view between header and strip; without a value, restores the layout. Slices replace the angiogram.
    void maximizeView(std::optional<MovableView> view);
    bool isViewMaximized() const { return maximizedView_.has_value(); }

    FoldingColumn& column(ColumnSide side) { return side == ColumnSide::Left ? *leftColumn_ : *rightColumn_; }
    ColumnLayout columns() const;   ///< current layout, or the one saved before a view was maximized
    void setColumns(const ColumnLayout& layout);

    QByteArray layoutState() const;   ///< window geometry, column widths, folded sections and popped-out views
    void restoreLayout(const QByteArray& state);
    void closeNow();   ///< closes without confirmation

signals:
    void filesDropped(const QStringList& paths);
    void closeRequested();
    void hideKeyToggled(bool held);   ///< emitted when H is pressed and released
    void escapePressed();
    void welcomeShown();
    /// Emitted on a left click or Enter in a slice, or a left click on a branch in the 3-D view.
    void pointPicked(const Eigen::Vector3d& pointInPatient);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void layOut();
    QWidget* makeLeftColumn();
    QWidget* makeCenter();
    QWidget* makeImagePlace();
    void connectSlices();
    void connectFrames();
    void placeViews();
    QWidget* makeRightColumn();
    void connectColumns();
    void saveWidthOf(ColumnSide side);
    void restoreFolding(QDataStream& stream);
    void showInRightColumn(QWidget* panel);
    void widenRightColumn();
    bool takesKey(QObject* watched) const;
    static bool isSliceEvent(QObject* watched, const QEvent& event);
    bool filterKey(QEvent* event);

    WindowActions* actions_;
    HeaderBar* header_;
    StepBar* steps_;
    PatientBar* patient_;
    BranchPanel* branches_;
    TreeView* treeView_;
    SliceModel* slices_;
    CornerViews* corner_;
    SlicesPage* slicesPage_;
    TracingPanel* tracing_;
    AngiogramView* angiogramView_;
    SideBySide* sideBySide_;
    ViewStrip* views_;
    WelcomePage* welcome_;
    QStackedWidget* center_;
    ViewFrame* imageFrame_;
    ViewFrame* cornerFrame_;
    ViewFrame* slicesFrame_;
    AngiogramPanel* angiogramPanel_;
    GeometryPanel* geometry_;
    PosePanel* pose_;
    LandmarkPanel* landmarks_;
    MeasurePanel* measure_;
    MarkPanel* marks_;
    ProfilePanel* profile_;
    RegistrationPanel* registration_;
    ResultPanel* result_;
    SnapshotPanel* snapshots_;
    TrialBar* trialBar_;
    FaultBar* faultBar_;
    QScrollArea* rightPanels_;
    BottomStrip* strip_;
    QSplitter* columns_;
    QSplitter* leftSplitter_;
    FoldingColumn* leftColumn_;
    FoldingColumn* rightColumn_;
    ColumnLayout layoutBefore_;   ///< column layout before a view was maximized
    QByteArray savedColumns_;   ///< splitter state before a view was maximized
    QByteArray savedLeft_;
    std::optional<MovableView> maximizedView_;
    bool slicesEnlarged_ = false;
    bool isHideKeyDown_ = false;
    bool closeAllowed_ = false;
};

}   // namespace angiopose::ui
