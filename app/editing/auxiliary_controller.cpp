#include "app/editing/auxiliary_controller.h"

#include "app/document/edit_case.h"
#include "core/case/case.h"
#include "core/registration/options/option_fields.h"
#include "core/support/quantile.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/result_sentences.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/bind_tool.h"
#include "ui/words/language.h"
#include "ui/words/number.h"
#include "ui/words/terms.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>

namespace angiopose::app {
namespace {

constexpr double insideShare = 0.5;   ///< fraction of a branch that must project into the lasso to select it

const std::string defaultMethod = "angiopose";
/// ID of the method that uses the auxiliary branches throughout.
const std::string alternatingMethod = "dynaweight";

/// Returns the name of a pose component as in the pose panel; the order is that of core::PoseUncertainty.
QString nameOfStep(std::size_t step)
{
    static const std::array names{QT_TRANSLATE_NOOP("angiopose::app::AuxiliaryController", "tilt"),
                                  QT_TRANSLATE_NOOP("angiopose::app::AuxiliaryController", "turn"),
                                  QT_TRANSLATE_NOOP("angiopose::app::AuxiliaryController", "roll"),
                                  QT_TRANSLATE_NOOP("angiopose::app::AuxiliaryController", "horizontal"),
                                  QT_TRANSLATE_NOOP("angiopose::app::AuxiliaryController", "vertical"),
                                  QT_TRANSLATE_NOOP("angiopose::app::AuxiliaryController", "depth")};
    return AuxiliaryController::tr(names[step]);
}

bool contains(const std::vector<int>& ids, int id)
{
    return std::ranges::find(ids, id) != ids.end();
}

bool alternates(const std::string& methodId)
{
    const core::OptionField* field = core::findOption("auxiliary");
    return field != nullptr && core::appliesTo(*field, methodId);
}

QString namesOf(const std::shared_ptr<const core::VesselTree>& tree, const std::vector<int>& branchIds)
{
    QStringList names;
    for (const int id : branchIds) {
        const core::VesselBranch* branch = tree ? tree->find(id) : nullptr;
        names << (branch ? ui::displayName(*branch) : QString::number(id));
    }
    return ui::joinNames(names);
}

/// Describes which branches the alternating method would currently use.
QString previewWords(const core::Case& current)
{
    if (!current.vessels.tree) {
        return {};
    }
    double lengthMm = 0.0;
    double chosenMm = 0.0;
    std::vector<int> chosenIds;   // excluded branches are omitted, since they are never used
    for (const core::VesselBranch& branch : current.vessels.tree->branches) {
        if (contains(current.vessels.excludedBranchIds, branch.id)) {
            continue;
        }
        lengthMm += branch.lengthMm();
        if (contains(current.vessels.auxiliaryBranchIds, branch.id)) {
            chosenMm += branch.lengthMm();
            chosenIds.push_back(branch.id);
        }
    }
    const QString chosen =
        chosenIds.empty()
            ? AuxiliaryController::tr(
                  "No auxiliary branches selected: the method uses the %1 nodes of the tree as auxiliary points.")
                  .arg(core::findNodes(*current.vessels.tree).size())
            : AuxiliaryController::tr("Auxiliary: %1 (%2 mm, %3 % of the tree).")
                  .arg(namesOf(current.vessels.tree, chosenIds))
                  .arg(ui::numberText(chosenMm, 0))
                  .arg(ui::numberText(100.0 * chosenMm / std::max(1e-9, lengthMm), 0));
    if (current.options.method == defaultMethod) {
        return chosenIds.empty()
                   ? AuxiliaryController::tr(
                         "No auxiliary branches selected: the method AngioPose weights all branches equally. If "
                         "auxiliary branches are selected, they determine the pose components that they constrain; the "
                         "other branches determine the remaining components.")
                   : AuxiliaryController::tr(
                         "%1 In the method AngioPose, these branches determine the pose components that they "
                         "constrain; the other branches determine the remaining components. The result also reports "
                         "the fit of all branches. If confidence is low, AngioPose also tries poses found from these "
                         "branches alone.")
                         .arg(chosen);
    }
    if (!alternates(current.options.method)) {
        return AuxiliaryController::tr("%1 The current method ignores this selection and uses all branches.")
            .arg(chosen);
    }
    const auto set = current.options.seed.auxiliary;
    return set == core::AuxiliarySet::Chosen
               ? chosen
               : AuxiliaryController::tr("%1 The method option “Auxiliary points” takes precedence.").arg(chosen);
}

/// Returns the median radius of the branch, mm; 0 if the branch has no radii.
double medianRadiusMm(const core::VesselBranch& branch)
{
    return branch.radiusMm.empty() ? 0.0 : core::quantile(branch.radiusMm, 0.5);
}

/// Builds the text of the auxiliary-branch dialog in the UI language: the effect of the selection and, if known, how
/// well the branches constrain the pose.
ui::AuxiliaryAdvice auxiliaryTexts(const core::Case& current, const std::optional<BranchAdvice>& advice)
{
    const auto& tree = current.vessels.tree;
    ui::AuxiliaryAdvice shown;
    shown.preview = previewWords(current);
    if (!alternates(current.options.method)) {
        shown.otherMethod = ui::methodName(alternatingMethod);
    }
    for (const core::VesselBranch& branch : tree ? tree->branches : std::vector<core::VesselBranch>{}) {
        shown.generations = std::max(shown.generations, branch.generation + 1);
        if (!branch.radiusMm.empty()) {
            shown.maxRadiusMm = std::max(shown.maxRadiusMm.value_or(0.0), medianRadiusMm(branch));
        }
    }
    for (std::size_t step = 0; advice && step < advice->constrainedBy.size(); ++step) {
        const auto row = static_cast<Eigen::Index>(step);
        shown.steps.push_back({nameOfStep(step), step < 3 ? QStringLiteral("°") : QStringLiteral("mm"),
                               advice->stdAllBranches[row], advice->stdAuxiliary[row],
                               namesOf(tree, advice->constrainedBy[step])});
    }
    shown.suggestion = advice ? namesOf(tree, advice->suggestedIds) : QString();
    return shown;
}

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
    connect(lasso, &ui::LassoTool::outlineDrawn, this, &AuxiliaryController::selectInside);
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
        adviser_.requestAdvice();
        show();   // shows the selection now; the figures follow once computed
    }
}

void AuxiliaryController::show()
{
    if (dialog_) {
        dialog_->showAdvice(auxiliaryTexts(document_.current(), adviser_.advice()));
    }
}

}   // namespace angiopose::app
