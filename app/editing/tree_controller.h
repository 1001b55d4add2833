#pragma once

#include "app/document/case_document.h"
#include "app/editing/branch_controller.h"
#include "core/support/result.h"
#include "core/vessel/tree_gaps.h"
#include "ui/words/retranslation.h"

#include <QObject>

#include <optional>

namespace angiopose::app {

/// Edits the vessel tree; each edit is a named undo step. An edit also removes the marks of deleted branches and any
/// result that no longer belongs to the tree; undo restores them. The pose stays unless it is the initial pose.
class TreeController : public QObject {
    Q_OBJECT
public:
    TreeController(CaseDocument& document, BranchController& branches, QObject* parent = nullptr);

    /// Sets the point last clicked in a view, which determines where a branch is cut or a root is set.
    void setClickedPoint(const Eigen::Vector3d& pointInPatient) { clickedPoint_ = pointInPatient; }

    void deleteSelected();
    void deleteSelectedSubtrees();
    void cutSelected();   ///< cuts the selected branch at the point of `setClickedPoint`
    void joinSelected();   ///< joins the two selected branches at their nearest ends
    void smoothSelected();
    void rootAtSelected();   ///< sets the root at the end of the selected branch nearest to that point
    void toggleHiddenSelected();
    void showAll();
    void prune(double minLengthMm, double minRadiusMm);
    void rename(int branchId, const QString& name);
    void setGeneration(const std::set<int>& branchIds, int generation);
    void bridge(const core::TreeGap& gap);

signals:
    void refused(const QString& reason);

private:
    using EditResult = core::Result<core::VesselTree>;
    const core::VesselTree* tree() const { return document_.current().vessels.tree.get(); }
    std::optional<int> singleSelectedBranch();
    bool hasSelection();
    ui::LocalizedText branchNamesOf(const std::set<int>& branchIds) const;
    ui::LocalizedText joinName(int branchId, int otherId) const;
    bool apply(const EditResult& edited, const ui::LocalizedText& name);
    void relabel(const EditResult& edited,
                 const ui::LocalizedText& name);   ///< changes only names and generations; the registration stays valid

    CaseDocument& document_;
    BranchController& branches_;
    std::optional<Eigen::Vector3d> clickedPoint_;
};

}   // namespace angiopose::app
