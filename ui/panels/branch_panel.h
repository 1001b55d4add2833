#pragma once

#include "core/vessel/vessel_tree.h"
#include "ui/controls/section.h"
#include "ui/scenes/overlay_scene.h"

#include <map>
#include <optional>
#include <set>

class QAction;
class QComboBox;
class QLineEdit;
class QListView;
class QPushButton;
class QSortFilterProxyModel;

namespace angiopose::ui {

class BranchModel;

/// Panel with the branch list. Reports hovering and selection immediately. Toggling auxiliary or excluded branches only
/// requests a change, to which the owner responds with `showMarks`.
class BranchPanel : public Section {
    Q_OBJECT
public:
    explicit BranchPanel(QWidget* parent = nullptr);

    void showTree(const core::VesselTree& tree);
    void showMarks(const BranchMarks& marks);   ///< emits no signal
    void showResiduals(const std::map<int, double>& residualMm, double scaleMaximumMm);
    /// Shows a defect of the tree ("" if there is none); if `isRepairable` is true, offers a button that repairs it.
    void showAdvice(const QString& text, bool isRepairable);
    void setEditActions(const QList<QAction*>& actions);   ///< sets the actions of the context menu
    void editName(int branchId);
    void focusFilter();
    QListView* list() const { return list_; }

signals:
    void hovered(std::optional<int> branchId);
    void selectionEdited(const std::set<int>& branchIds);
    void auxiliaryToggled(const std::set<int>& branchIds);
    void excludedToggled(const std::set<int>& branchIds);
    void auxiliaryReplaced(const std::set<int>& branchIds);
    void auxiliaryCleared();
    void renamed(int branchId, const QString& name);
    void generationChosen(const std::set<int>& branchIds, int generation);
    void repairRequested();
    void adviceShown();
    void repairableChanged(bool isRepairable);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeFilterRow();
    QWidget* makeAdviceRow();
    void sortBy(int choice);
    void selectMarked();
    QModelIndex indexOf(int branchId) const;   ///< index of the branch in the sorted and filtered list
    std::set<int> selectedIds() const;
    std::set<int> affectedBy(int branchId) const;   ///< the selection if it contains the branch, otherwise the branch
    void showContextMenu(const QPoint& position);
    void showKeys();
    void reportSelection();

    BranchModel* model_;
    QSortFilterProxyModel* proxy_;
    QListView* list_;
    QLineEdit* filter_;
    QComboBox* order_;
    QWidget* filterRow_;
    QWidget* adviceRow_;
    QLabel* advice_;
    QPushButton* repair_;
    QList<QAction*> editActions_;
    QLabel* empty_;
    BranchMarks marks_;
    bool isUpdating_ = false;   ///< true while the program, not the user, changes the selection
};

}   // namespace angiopose::ui
