#include "app/editing/auxiliary_controller.h"

#include "app/document/edit_case.h"
#include "app/editing/auxiliary_words.h"
#include "ui/actions/window_actions.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/bind_tool.h"
#include "ui/words/terms.h"

#include <set>

namespace angiopose::app {
namespace {

constexpr double insideShare = 0.5;   ///< share of a branch's projection inside the lasso that selects it

/// Returns the fraction of the branch's points that project inside the outline.
double shareInside(const core::VesselBranch& branch, const core::ProjectionCamera& camera,
                   const core::RigidTransform& cameraFromPatient, const QPolygonF& outline)
{
    int inside = 0;
    for (const Eigen::Vector3d& point : branch.pointsInPatient) {
        const auto pixel = core::project(camera, cameraFromPatient * point);
        inside += pixel && outline.containsPoint({pixel->x(), pixel->y()}, Qt::OddEvenFill) ? 1 : 0;
    }
    return static_cast<double>(inside) / static_cast<double>(branch.pointsInPatient.size());
}

}   // namespace

AuxiliaryController::AuxiliaryController(CaseDocument& document, BranchController& branches, ui::WindowActions& actions,
                                         ui::AngiogramView& view, QWidget& dialogParent, QObject* parent)
    : QObject(parent),
      document_(document),
      branches_(branches),
      actions_(actions),
      view_(view),
      dialogParent_(dialogParent),
      adviser_(document)
{
    auto* lasso = new ui::LassoTool(view_);
    ui::bindTool(*actions_[ui::Command::Lasso], view_, *lasso);
    connect(lasso, &ui::LassoTool::enclosed, this, &AuxiliaryController::selectInside);
    connect(actions_[ui::Command::AuxiliaryAdvice], &QAction::triggered, this, &AuxiliaryController::open);
    connect(&document_, &CaseDocument::changed, this, &AuxiliaryController::request);
    connect(&adviser_, &BranchAdviser::adviceReady, this, &AuxiliaryController::show);
}

void AuxiliaryController::open()
{
    if (!dialog_) {
        dialog_ = new ui::AuxiliaryDialog(&dialogParent_);
        connectDialog();
    }
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
    request();
}

void AuxiliaryController::connectDialog()
{
    ui::AuxiliaryDialog* dialog = dialog_;
    connect(dialog, &ui::AuxiliaryDialog::generationRequested, this, &AuxiliaryController::selectGenerations);
    connect(dialog, &ui::AuxiliaryDialog::radiusRequested, this, &AuxiliaryController::selectByRadius);
    connect(dialog, &ui::AuxiliaryDialog::suggestionRequested, this, &AuxiliaryController::selectSuggested);
    connect(dialog, &ui::AuxiliaryDialog::methodRequested, this, &AuxiliaryController::useAlternatingMethod);
    connect(dialog, &ui::AuxiliaryDialog::clearRequested, this, [this] { branches_.setAuxiliary({}); });
    connect(dialog, &ui::AuxiliaryDialog::viewRequested, actions_[ui::Command::AuxiliaryInView], &QAction::trigger);
    connect(dialog, &ui::AuxiliaryDialog::lassoRequested, this, [this] {
        actions_[ui::Command::Lasso]->setChecked(true);
        dialogParent_.activateWindow();
        view_.setFocus();
    });
}

void AuxiliaryController::useAlternatingMethod()
{
    core::RegistrationOptions options = document_.current().options;
    options.method = alternatingMethod;
    document_.push(std::make_unique<ChangeOptions>(document_, ChangeOptions::Values{options}, [] {
        return tr("Change method to %1").arg(ui::methodName(alternatingMethod));
    }));
}

void AuxiliaryController::selectInside(const QPolygonF& outlineInImagePx, ui::LassoEffect effect)
{
    const core::Case& current = document_.current();
    const auto camera = core::cameraOf(current.shown());
    if (!current.vessels.tree || !camera) {
        return;
    }
    std::set<int> inside;
    for (const core::VesselBranch& branch : current.vessels.tree->branches) {
        const double share = shareInside(branch, camera.value(), current.shown().cameraFromPatient, outlineInImagePx);
        if (share >= insideShare && !branches_.marks().excluded.contains(branch.id)) {
            inside.insert(branch.id);
        }
    }
    if (inside.empty()) {
        emit refused(tr("No branch lies mostly inside the lasso."));
        return;
    }
    std::set<int> chosen = effect == ui::LassoEffect::Replaces ? std::set<int>{} : branches_.marks().auxiliary;
    for (const int id : inside) {
        if (effect == ui::LassoEffect::Removes) {
            chosen.erase(id);
        } else {
            chosen.insert(id);
        }
    }
    branches_.setAuxiliary(chosen);
}

void AuxiliaryController::selectGenerations(int last)
{
    std::set<int> chosen;
    const auto& tree = document_.current().vessels.tree;
    for (const core::VesselBranch& branch : tree ? tree->branches : std::vector<core::VesselBranch>{}) {
        if (branch.generation >= 0 && branch.generation <= last && !branches_.marks().excluded.contains(branch.id)) {
            chosen.insert(branch.id);
        }
    }
    if (chosen.empty()) {
        emit refused(tr("This tree has no generation data."));
    } else {
        branches_.setAuxiliary(chosen);
    }
}

void AuxiliaryController::selectByRadius(double atLeastMm)
{
    std::set<int> chosen;
    const auto& tree = document_.current().vessels.tree;
    for (const core::VesselBranch& branch : tree ? tree->branches : std::vector<core::VesselBranch>{}) {
        if (!branch.radiusMm.empty() && medianRadiusMm(branch) >= atLeastMm &&
            !branches_.marks().excluded.contains(branch.id)) {
            chosen.insert(branch.id);
        }
    }
    if (chosen.empty()) {
        emit refused(tr("No branch reaches this radius."));
    } else {
        branches_.setAuxiliary(chosen);
    }
}

const std::vector<int>& AuxiliaryController::suggestion() const
{
    static const std::vector<int> none;
    return adviser_.advice() ? adviser_.advice()->suggestedIds : none;
}

void AuxiliaryController::selectSuggested()
{
    if (!suggestion().empty()) {
        branches_.setAuxiliary({suggestion().begin(), suggestion().end()});
    }
}

void AuxiliaryController::request()
{
    if (dialog_ && dialog_->isVisible()) {
        adviser_.ask();
        show();   // shows the selection now; the figures follow when computed
    }
}

void AuxiliaryController::show()
{
    if (dialog_) {
        dialog_->showAdvice(auxiliaryTexts(document_.current(), adviser_.advice()));
    }
}

}   // namespace angiopose::app
