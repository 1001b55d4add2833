#pragma once

#include "app/document/case_document.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/words/spoken.h"

#include <QObject>

#include <map>
#include <set>

namespace angiopose::app {

/// Which branches are hovered and selected (shared by list and views), and which count for what (part of the case).
class BranchController : public QObject {
    Q_OBJECT
public:
    explicit BranchController(CaseDocument& document, QObject* parent = nullptr);

    const ui::BranchMarks& marks() const { return marks_; }

    void hover(std::optional<int> branchId);
    void select(const std::set<int>& branchIds);
    void click(int branchId, Qt::KeyboardModifiers modifiers);   ///< in a view: Ctrl or Shift adds or removes
    void selectAll();
    void toggleAuxiliary(const std::set<int>& branchIds);
    void toggleExcluded(const std::set<int>& branchIds);
    void setAuxiliary(const std::set<int>& branchIds);
    /// Makes the branches auxiliary whose projection lies wholly in a part of the image, or whose radius is not below
    /// the tree's median; says so where there is none.
    void setAuxiliaryInside(const std::map<int, ui::ViewRect>& extents, const ui::ViewRect& part);
    void setAuxiliaryWide();
    void followDocument();   ///< takes over the case's choices; forgets branches that are gone

signals:
    void marksChanged();
    void refused(const QString& why);

private:
    ui::Words namesOf(const std::set<int>& branchIds) const;

    CaseDocument& document_;
    ui::BranchMarks marks_;
};

}   // namespace angiopose::app