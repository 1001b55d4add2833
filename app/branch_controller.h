#pragma once

#include "app/case_document.h"
#include "ui/scenes/overlay_scene.h"

#include <QObject>

#include <set>

namespace app {

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
    void followDocument();   ///< takes over the case's choices; forgets branches that are gone

signals:
    void marksChanged();
    void refused(const QString& why);

private:
    QString namesOf(const std::set<int>& branchIds) const;

    CaseDocument& document_;
    ui::BranchMarks marks_;
};

}   // namespace app
