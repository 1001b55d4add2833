#include "app/editing/branch_controller.h"

#include "app/document/edit_case.h"
#include "app/editing/branch_words.h"
#include "ui/panels/result_sentences.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace angiopose::app {
namespace {

/// Removes `ids` from the set if the set contains all of them, otherwise adds them.
std::set<int> toggled(std::set<int> set, const std::set<int>& ids)
{
    const bool allIn = std::ranges::includes(set, ids);
    for (const int id : ids) {
        if (allIn) {
            set.erase(id);
        } else {
            set.insert(id);
        }
    }
    return set;
}

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

}   // namespace

BranchController::BranchController(CaseDocument& document, QObject* parent) : QObject(parent), document_(document) {}

void BranchController::hover(std::optional<int> branchId)
{
    if (marks_.hovered != branchId) {
        marks_.hovered = branchId;
        emit marksChanged();
    }
}

void BranchController::select(const std::set<int>& branchIds)
{
    if (marks_.selected != branchIds) {
        marks_.selected = branchIds;
        emit marksChanged();
    }
}

void BranchController::click(int branchId, Qt::KeyboardModifiers modifiers)
{
    const bool adds = modifiers & (Qt::ControlModifier | Qt::ShiftModifier);
    select(adds ? toggled(marks_.selected, {branchId}) : std::set{branchId});
}

void BranchController::selectAll()
{
    std::set<int> ids;
    if (const auto& tree = document_.current().vessels.tree) {
        for (const core::VesselBranch& branch : tree->branches) {
            ids.insert(branch.id);
        }
    }
    select(ids);
}

void BranchController::toggleAuxiliary(const std::set<int>& branchIds)
{
    std::set<int> choosable;
    std::ranges::set_difference(branchIds, marks_.excluded, std::inserter(choosable, choosable.end()));
    if (choosable.empty()) {
        emit refused(branchIds.empty() ? tr("Select a branch first: click it in the list or in a view.")
                                       : tr("Excluded branches cannot be auxiliary. Include them first (X)."));
        return;
    }
    setAuxiliary(toggled(marks_.auxiliary, choosable));
}

void BranchController::setAuxiliary(const std::set<int>& branchIds)
{
    const std::vector<int> ids(branchIds.begin(), branchIds.end());
    if (ids != document_.current().vessels.auxiliaryBranchIds) {
        document_.push(
            std::make_unique<SelectAuxiliary>(document_, ids, [] { return tr("Choose auxiliary branches"); }));
    }
}

void BranchController::toggleExcluded(const std::set<int>& branchIds)
{
    if (branchIds.empty()) {
        emit refused(tr("Select a branch first: click it in the list or in a view."));
        return;
    }
    const std::set<int> excluded = toggled(marks_.excluded, branchIds);
    const auto& tree = document_.current().vessels.tree;
    if (tree && excluded.size() >= tree->branches.size()) {
        emit refused(tr("At least one branch must remain."));
        return;
    }
    const bool leaves = excluded.size() > marks_.excluded.size();
    const auto name = [leaves, names = branchNamesOf(branchIds)] {
        return (leaves ? tr("Exclude %1") : tr("Include %1")).arg(names());
    };
    document_.push(std::make_unique<ExcludeBranches>(
        document_,
        ExcludeBranches::Values{{excluded.begin(), excluded.end()}, removeResults(document_.current().views)}, name));
}

void BranchController::setAuxiliaryInside(const std::map<int, ui::ViewRect>& extents, const ui::ViewRect& part)
{
    std::set<int> inside;
    for (const auto& [branchId, extent] : extents) {
        const bool isInside = extent.left >= part.left && extent.right <= part.right && extent.top >= part.top &&
                              extent.bottom <= part.bottom;
        if (isInside && !marks_.excluded.contains(branchId)) {
            inside.insert(branchId);
        }
    }
    if (inside.empty()) {
        emit refused(tr("No branch is completely visible. Zoom out or pan the image."));
    } else {
        setAuxiliary(inside);
    }
}

void BranchController::setAuxiliaryByRadius()
{
    const auto& tree = document_.current().vessels.tree;
    std::vector<std::pair<double, int>> radii;
    for (const core::VesselBranch& branch : tree ? tree->branches : std::vector<core::VesselBranch>{}) {
        if (!branch.radiusMm.empty() && !marks_.excluded.contains(branch.id)) {
            radii.emplace_back(medianOf(branch.radiusMm), branch.id);
        }
    }
    if (radii.empty()) {
        emit refused(tr("This tree has no radii."));
        return;
    }
    std::ranges::sort(radii, std::greater{});
    std::set<int> wide;
    for (std::size_t i = 0; i < (radii.size() + 1) / 2; ++i) {
        wide.insert(radii[i].second);
    }
    setAuxiliary(wide);
}

void BranchController::updateFromDocument()
{
    const core::Case& current = document_.current();
    ui::BranchMarks marks = marks_;
    marks.auxiliary = {current.vessels.auxiliaryBranchIds.begin(), current.vessels.auxiliaryBranchIds.end()};
    marks.excluded = {current.vessels.excludedBranchIds.begin(), current.vessels.excludedBranchIds.end()};
    marks.hidden = {current.vessels.hiddenBranchIds.begin(), current.vessels.hiddenBranchIds.end()};
    std::erase_if(marks.selected,
                  [&current](int id) { return !current.vessels.tree || !current.vessels.tree->find(id); });
    if (marks.hovered && (!current.vessels.tree || !current.vessels.tree->find(*marks.hovered))) {
        marks.hovered.reset();
    }
    if (marks != marks_) {
        marks_ = marks;
        emit marksChanged();
    }
}

ui::LocalizedText BranchController::branchNamesOf(const std::set<int>& branchIds) const
{
    const auto& tree = document_.current().vessels.tree;
    return branchNames(tree ? *tree : core::VesselTree{}, branchIds);
}

}   // namespace angiopose::app
