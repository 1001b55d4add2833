#pragma once

#include "app/document/case_document.h"
#include "app/editing/branch_controller.h"
#include "core/support/result.h"
#include "core/vessel/tree_gaps.h"
#include "ui/words/spoken.h"

#include <QObject>

#include <optional>

namespace angiopose::app {

/// Edits of the vessel tree, each one named step of undo. Marks of branches that go, and a result that no longer
/// belongs to the tree, go with the edit and come back with its undo. The pose stays, unless it is the start pose.
class TreeController : public QObject {
    Q_OBJECT
public:
    TreeController(CaseDocument& document, BranchController& branches, QObject* parent = nullptr);

    /// Where the user pointed last, in a view: the place of a cut or a root.
    void setPlace(const Eigen::Vector3d& pointInPatient) { place_ = pointInPatient; }

    void deleteSelected();
    void deleteSelectedSubtrees();
    void cutSelected();   ///< at the place
    void joinSelected();   ///< two branches over their nearest ends
    void smoothSelected();
    void rootAtSelected();   ///< at the selected branch's end that is nearest to the place
    void toggleHiddenSelected();
    void showAll();
    void prune(double minLengthMm, double minRadiusMm);
    void rename(int branchId, const QString& name);
    void setGeneration(const std::set<int>& branchIds, int generation);
    void mend(const core::TreeGap& gap);

signals:
    void refused(const QString& why);

private:
    using Edited = core::Result<core::VesselTree>;
    const core::VesselTree* tree() const { return document_.current().vessels.tree.get(); }
    std::optional<int> onlySelected();
    bool hasSelection();
    ui::Words namesOf(const std::set<int>& branchIds) const;
    ui::Words joinName(int branchId, int otherId) const;
    bool apply(const Edited& edited, const ui::Words& name);
    void relabel(const Edited& edited, const ui::Words& name);   ///< names and counts: what was registered still holds

    CaseDocument& document_;
    BranchController& branches_;
    std::optional<Eigen::Vector3d> place_;
};

}   // namespace angiopose::app