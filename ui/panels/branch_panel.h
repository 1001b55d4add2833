#pragma once

#include "core/vessel/vessel_tree.h"
#include "ui/panels/section.h"
#include "ui/scenes/overlay_scene.h"

#include <map>
#include <optional>
#include <set>

class QListView;

namespace ui {

class BranchModel;

/// The branch list. Hovering and selecting are reported as they happen; switching branches on and off is a wish that
/// the owner answers with `showMarks`.
class BranchPanel : public Section {
    Q_OBJECT
public:
    explicit BranchPanel(QWidget* parent = nullptr);

    void showTree(const core::VesselTree& tree);
    void showMarks(const BranchMarks& marks);   ///< silent
    void showResiduals(const std::map<int, double>& residualMm, double scaleMaximumMm);
    QListView* list() const { return list_; }

signals:
    void hovered(std::optional<int> branchId);
    void selectionEdited(const std::set<int>& branchIds);
    void auxiliaryToggled(const std::set<int>& branchIds);
    void excludedToggled(const std::set<int>& branchIds);
    void onlyTheseAuxiliary(const std::set<int>& branchIds);
    void auxiliaryCleared();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::set<int> selectedIds() const;
    std::set<int> affectedBy(int branchId) const;   ///< the selection when it contains the branch, else the branch
    void showContextMenu(const QPoint& position);
    void reportSelection();

    BranchModel* model_;
    QListView* list_;
    QLabel* empty_;
    BranchMarks marks_;
    bool showing_ = false;   ///< true while the owner, not the user, changes the selection
};

}   // namespace ui
