#pragma once

#include "ui/actions/command.h"
#include "ui/slices/slice_view.h"
#include "ui/words/retranslation.h"

#include <QWidget>

#include <array>
#include <optional>

class QStackedWidget;
class QToolButton;

namespace angiopose::ui {

class ScanBar;
class TreeView;

/// Area below the branch list that shows the 3-D view or, if there is a scan, one plane of the scan.
class CornerViews : public QWidget {
    Q_OBJECT
public:
    CornerViews(TreeView* treeView, SliceModel& model, QWidget* parent = nullptr);

    std::optional<core::BodyPlane> shownPlane() const;
    void showPlane(std::optional<core::BodyPlane> plane);   ///< if not set, shows the 3-D view; requires a scan
    void showNext();
    SliceView& slice() { return *slice_; }
    ScanBar& scanBar() { return *scanBar_; }   ///< bar above the 3-D view, shown if there is a scan

signals:
    void planeChanged(std::optional<core::BodyPlane> plane);
    void enlargeRequested();   ///< requests enlarging all slices
    void maximizeRequested();   ///< requests maximizing this area, or restoring the layout
    void popOutRequested();   ///< requests popping out this area, or docking it

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QToolButton* makeToolButton(const QString& sign, const LocalizedText& name, Command command);
    QToolButton* makeTab(const LocalizedText& text, std::optional<core::BodyPlane> plane);
    void followScan();

    SliceModel& model_;
    QWidget* bar_;
    QToolButton* allSlices_;
    QStackedWidget* stack_;
    TreeView* treeView_;
    SliceView* slice_;
    ScanBar* scanBar_;
    std::array<QToolButton*, 4> tabs_{};   ///< 3-D view first, then planes in the order of `core::bodyPlanes`
    std::optional<core::BodyPlane> requestedPlane_;
};

}   // namespace angiopose::ui
