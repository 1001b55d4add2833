#pragma once

#include "app/document/case_document.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/words/retranslation.h"

#include <QObject>

#include <map>
#include <set>

namespace angiopose::app {

/// Holds the hovered and the selected branches, which the list and the views share, and edits the auxiliary, excluded
/// and hidden branches, which are part of the case.
class BranchController : public QObject {
    Q_OBJECT
public:
    explicit BranchController(CaseDocument& document, QObject* parent = nullptr);

    const ui::BranchMarks& marks() const { return marks_; }

    void hover(std::optional<int> branchId);
    void select(const std::set<int>& branchIds);
    void click(int branchId, Qt::KeyboardModifiers modifiers);   ///< click in a view; Ctrl or Shift toggles the branch
    void selectAll();
    void toggleAuxiliary(const std::set<int>& branchIds);
    void toggleExcluded(const std::set<int>& branchIds);
    void setAuxiliary(const std::set<int>& branchIds);
    /// Selects as auxiliary the branches that project entirely into a part of the image, or those whose radius is at
    /// least the tree's median; reports if there are no such branches.
    void setAuxiliaryInside(const std::map<int, ui::ViewRect>& extents, const ui::ViewRect& part);
    void setAuxiliaryByRadius();
    void updateFromDocument();   ///< updates the branch sets from the case and removes deleted branches

signals:
    void marksChanged();
    void refused(const QString& reason);

private:
    ui::LocalizedText branchNamesOf(const std::set<int>& branchIds) const;

    CaseDocument& document_;
    ui::BranchMarks marks_;
};

}   // namespace angiopose::app
