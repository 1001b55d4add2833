#include "app/editing/tree_controller.h"

#include "app/document/edit_case.h"
#include "app/editing/branch_words.h"
#include "core/vessel/edit_tree.h"
#include "core/vessel/root_tree.h"
#include "ui/panels/result_sentences.h"
#include "ui/words/message_text.h"

#include <algorithm>

namespace angiopose::app {
namespace {

constexpr double smoothWidthMm = 8.0;   // width of the smoothing window along the centerline

QString words(const core::Error& error)
{
    return ui::messageText(error.message);
}

}   // namespace

TreeController::TreeController(CaseDocument& document, BranchController& branches, QObject* parent)
    : QObject(parent), document_(document), branches_(branches)
{
}

bool TreeController::hasSelection()
{
    const bool has = tree() && !branches_.marks().selected.empty();
    if (!has) {
        emit refused(tr("Select a branch first: click it in the list or in a view."));
    }
    return has;
}

std::optional<int> TreeController::singleSelectedBranch()
{
    const std::set<int>& selected = branches_.marks().selected;
    if (!tree() || selected.size() != 1) {
        emit refused(tr("Select one branch: click it in the list or in a view."));
        return std::nullopt;
    }
    return *selected.begin();
}

ui::LocalizedText TreeController::branchNamesOf(const std::set<int>& branchIds) const
{
    return branchNames(*tree(), branchIds);
}

ui::LocalizedText TreeController::joinName(int branchId, int otherId) const
{
    return [first = branchNamesOf({branchId}), second = branchNamesOf({otherId})] {
        return tr("Join %1 and %2").arg(first(), second());
    };
}

bool TreeController::apply(const EditResult& edited, const ui::LocalizedText& name)
{
    if (!edited) {
        emit refused(words(edited.error()));
        return false;
    }
    return document_.push(editTree(document_, edited.value(), name));
}

void TreeController::relabel(const EditResult& edited, const ui::LocalizedText& name)
{
    if (!edited) {
        emit refused(words(edited.error()));
        return;
    }
    document_.push(std::make_unique<RelabelTree>(
        document_, RelabelTree::Values{std::make_shared<const core::VesselTree>(edited.value()), true}, name));
}

void TreeController::deleteSelected()
{
    if (!hasSelection()) {
        return;
    }
    const std::set<int> gone = branches_.marks().selected;
    const core::VesselTree left = core::withoutBranches(*tree(), {gone.begin(), gone.end()});
    if (left.branches.empty()) {
        emit refused(tr("At least one branch must remain."));
        return;
    }
    apply(left, [names = branchNamesOf(gone)] { return tr("Delete %1").arg(names()); });
}

void TreeController::deleteSelectedSubtrees()
{
    if (!hasSelection()) {
        return;
    }
    EditResult left = *tree();
    for (const int id : branches_.marks().selected) {
        if (left && left.value().find(id)) {   // otherwise already deleted with another subtree
            left = core::removeSubtree(left.value(), id);
        }
    }
    apply(left,
          [names = branchNamesOf(branches_.marks().selected)] { return tr("Delete %1 and descendants").arg(names()); });
}

void TreeController::cutSelected()
{
    const auto id = singleSelectedBranch();
    if (!id) {
        return;
    }
    if (!clickedPoint_) {
        emit refused(tr("First click the position of the cut, in a slice or on the branch in the 3-D view."));
        return;
    }
    apply(core::splitAt(*tree(), *id, core::nearestPoint(*tree(), *id, *clickedPoint_)),
          [names = branchNamesOf({*id})] { return tr("Cut %1").arg(names()); });
}

void TreeController::joinSelected()
{
    const std::set<int> pair = branches_.marks().selected;
    if (!tree() || pair.size() != 2) {
        emit refused(tr("Select two branches to join (Ctrl+click adds the second)."));
        return;
    }
    apply(core::joinBranches(*tree(), *pair.begin(), *pair.rbegin()), joinName(*pair.begin(), *pair.rbegin()));
}

void TreeController::smoothSelected()
{
    if (!hasSelection()) {
        return;
    }
    EditResult smooth = *tree();
    for (const int id : branches_.marks().selected) {
        smooth = smooth ? core::smoothBranch(smooth.value(), id, smoothWidthMm) : smooth;
    }
    apply(smooth, [names = branchNamesOf(branches_.marks().selected)] { return tr("Smooth %1").arg(names()); });
}

void TreeController::rootAtSelected()
{
    const auto id = singleSelectedBranch();
    if (!id) {
        return;
    }
    const auto& points = tree()->find(*id)->pointsInPatient;
    const Eigen::Vector3d place = clickedPoint_.value_or(points.front());
    const bool isFront = (points.front() - place).norm() <= (points.back() - place).norm();
    apply(core::rootTreeAt(*tree(), isFront ? points.front() : points.back()),
          [names = branchNamesOf({*id})] { return tr("Set root at %1").arg(names()); });
}

void TreeController::toggleHiddenSelected()
{
    if (!hasSelection()) {
        return;
    }
    const std::set<int>& selected = branches_.marks().selected;
    std::set<int> hidden = branches_.marks().hidden;
    const bool shows = std::ranges::includes(hidden, selected);
    for (const int id : selected) {
        shows ? static_cast<void>(hidden.erase(id)) : static_cast<void>(hidden.insert(id));
    }
    const auto name = [shows, names = branchNamesOf(selected)] {
        return shows ? tr("Show %1").arg(names()) : tr("Hide %1").arg(names());
    };
    document_.push(
        std::make_unique<HideBranches>(document_, HideBranches::Values{{hidden.begin(), hidden.end()}}, name));
}

void TreeController::showAll()
{
    if (!document_.current().vessels.hiddenBranchIds.empty()) {
        document_.push(std::make_unique<HideBranches>(document_, HideBranches::Values{std::vector<int>()},
                                                      [] { return tr("Show all branches"); }));
    }
}

void TreeController::prune(double minLengthMm, double minRadiusMm)
{
    if (!tree()) {
        return;
    }
    const EditResult left = core::pruneTree(*tree(), minLengthMm, minRadiusMm);
    if (left && left.value().branches.size() == tree()->branches.size()) {
        emit refused(tr("No terminal branch is below these limits."));
        return;
    }
    const auto gone = left ? tree()->branches.size() - left.value().branches.size() : 0;
    apply(left, [gone] { return gone == 1 ? tr("Prune 1 branch") : tr("Prune %1 branches").arg(gone); });
}

void TreeController::rename(int branchId, const QString& name)
{
    const core::VesselBranch* branch = tree() ? tree()->find(branchId) : nullptr;
    const std::string wanted = name.trimmed().toStdString();
    if (branch && branch->name != wanted) {
        relabel(core::renameBranch(*tree(), branchId, wanted),
                [names = branchNamesOf({branchId})] { return tr("Rename %1").arg(names()); });
    }
}

void TreeController::setGeneration(const std::set<int>& branchIds, int generation)
{
    if (!tree() || branchIds.empty()) {
        return;
    }
    EditResult counted = *tree();
    for (const int id : branchIds) {
        counted = counted ? core::assignGeneration(counted.value(), id, generation) : counted;
    }
    relabel(counted, [names = branchNamesOf(branchIds)] { return tr("Set generation of %1").arg(names()); });
}

void TreeController::bridge(const core::TreeGap& gap)
{
    if (!tree()) {
        return;
    }
    EditResult whole = core::closeGap(*tree(), gap);
    const core::VesselBranch& first = tree()->branches.front();
    if (whole && first.generation >= 0) {   // renumbers the generations beyond the gap, starting at the root
        whole = core::rootTreeAt(whole.value(), first.pointsInPatient.front());
    }
    apply(whole, joinName(gap.fromBranchId, gap.toBranchId));
}

}   // namespace angiopose::app
