#include "app/editing/auxiliary_controller.h"
#include "app/document/edit_case.h"

#include "core/registration/options/option_fields.h"
#include "core/registration/pose/start_prior.h"
#include "core/support/quantile.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/result_sentences.h"
#include "ui/panels/snapshot_panel.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/bind_tool.h"
#include "ui/words/language.h"
#include "ui/words/number.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace angiopose::app {
namespace {

constexpr int branchesPerStep = 2;   ///< named per step of the pose
constexpr double insideShare = 0.5;   ///< of a branch's projection, from which a lasso holds it

/// Order of core::PoseUncertainty; in the words of the pose panel.
QString nameOfStep(std::size_t step)
{
    static const std::array names{QT_TRANSLATE_NOOP("angiopose::app::AuxiliaryController", "tilt"),
                                  QT_TRANSLATE_NOOP("angiopose::app::AuxiliaryController", "turn"),
                                  QT_TRANSLATE_NOOP("angiopose::app::AuxiliaryController", "roll"),
                                  QT_TRANSLATE_NOOP("angiopose::app::AuxiliaryController", "sideways"),
                                  QT_TRANSLATE_NOOP("angiopose::app::AuxiliaryController", "up–down"),
                                  QT_TRANSLATE_NOOP("angiopose::app::AuxiliaryController", "depth")};
    return AuxiliaryController::tr(names[step]);
}

const std::string defaultMethod = "angiopose";
const std::string alternatingMethod = "dynaweight";

bool contains(const std::vector<int>& ids, int id)
{
    return std::ranges::find(ids, id) != ids.end();
}

bool alternates(const std::string& methodId)
{
    const core::OptionField* field = core::findOption("auxiliary");
    return field != nullptr && core::isFor(*field, methodId);
}

double medianRadiusMm(const core::VesselBranch& branch)
{
    return branch.radiusMm.empty() ? 0.0 : core::quantile(branch.radiusMm, 0.5);
}

/// Share of the branch's points whose projections lie inside.
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

core::Vector6d inDegrees(core::Vector6d std)
{
    std.head<3>() *= 180.0 / std::numbers::pi;
    return std;
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
      job_([this](const Advice& advice) { take(advice); })
{
    auto* lasso = new ui::LassoTool(view_);
    ui::bindTool(*actions_[ui::Command::Lasso], view_, *lasso);
    connect(lasso, &ui::LassoTool::enclosed, this, &AuxiliaryController::chooseInside);
    connect(actions_[ui::Command::AuxiliaryAdvice], &QAction::triggered, this, &AuxiliaryController::open);
    connect(&document_, &CaseDocument::changed, this, &AuxiliaryController::request);
}

void AuxiliaryController::take(const Advice& advice)
{
    advice_ = advice;
    isKnown_ = true;
    if (std::exchange(isWanted_, false)) {
        start();
    }
    show();
    emit adviceChanged();
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
    show();
}

void AuxiliaryController::connectDialog()
{
    ui::AuxiliaryDialog* dialog = dialog_;
    connect(dialog, &ui::AuxiliaryDialog::generationRequested, this, &AuxiliaryController::chooseGenerations);
    connect(dialog, &ui::AuxiliaryDialog::radiusRequested, this, &AuxiliaryController::chooseWide);
    connect(dialog, &ui::AuxiliaryDialog::suggestionRequested, this, &AuxiliaryController::chooseSuggestion);
    connect(dialog, &ui::AuxiliaryDialog::methodRequested, this, &AuxiliaryController::takeAlternatingMethod);
    connect(dialog, &ui::AuxiliaryDialog::clearRequested, this, [this] { branches_.setAuxiliary({}); });
    connect(dialog, &ui::AuxiliaryDialog::viewRequested, actions_[ui::Command::AuxiliaryInView], &QAction::trigger);
    connect(dialog, &ui::AuxiliaryDialog::lassoRequested, this, [this] {
        actions_[ui::Command::Lasso]->setChecked(true);
        dialogParent_.activateWindow();
        view_.setFocus();
    });
}

void AuxiliaryController::takeAlternatingMethod()
{
    core::RegistrationOptions options = document_.current().options;
    options.method = alternatingMethod;
    document_.push(std::make_unique<ChangeOptions>(document_, ChangeOptions::Values{options}, [] {
        return tr("Change method to %1").arg(ui::methodWords(alternatingMethod));
    }));
}

void AuxiliaryController::chooseInside(const QPolygonF& outlineInImagePx, ui::LassoEffect effect)
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

void AuxiliaryController::chooseGenerations(int last)
{
    std::set<int> chosen;
    const auto& tree = document_.current().vessels.tree;
    for (const core::VesselBranch& branch : tree ? tree->branches : std::vector<core::VesselBranch>{}) {
        if (branch.generation >= 0 && branch.generation <= last && !branches_.marks().excluded.contains(branch.id)) {
            chosen.insert(branch.id);
        }
    }
    if (chosen.empty()) {
        emit refused(tr("This tree knows no generations."));
    } else {
        branches_.setAuxiliary(chosen);
    }
}

void AuxiliaryController::chooseWide(double atLeastMm)
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
        emit refused(tr("No branch is that wide."));
    } else {
        branches_.setAuxiliary(chosen);
    }
}

void AuxiliaryController::chooseSuggestion()
{
    if (isKnown_ && !advice_.suggested.empty()) {
        branches_.setAuxiliary({advice_.suggested.begin(), advice_.suggested.end()});
    }
}

void AuxiliaryController::request()
{
    if (!dialog_ || !dialog_->isVisible()) {
        return;
    }
    if (job_.isRunning()) {
        isWanted_ = true;
    } else {
        start();
    }
    show();   // the choice at once, the numbers when they are known
}

void AuxiliaryController::start()
{
    const core::Case& current = document_.current();
    const auto camera = core::cameraOf(current.shown());
    if (!current.vessels.tree || !camera) {
        isKnown_ = false;
        show();
        return;
    }
    const core::Vector6d priorStd =
        core::startPrior({}, current.options).std();   // what the solver believes of a start pose
    job_.start([tree = current.vessels.tree, camera = camera.value(), pose = current.shown().cameraFromPatient,
                excluded = current.vessels.excludedBranchIds, chosen = current.vessels.auxiliaryBranchIds,
                priorStd](JobLink<double>&) -> core::Result<Advice> {
        const auto branches = core::branchInformation(core::without(*tree, excluded), camera, pose);
        std::vector<int> all(branches.size());
        std::ranges::transform(branches, all.begin(), &core::BranchInformation::branchId);
        Advice advice;
        advice.stdOfAll = inDegrees(core::expectedStd(branches, all, priorStd));
        advice.stdOfChosen = inDegrees(core::expectedStd(branches, chosen.empty() ? all : chosen, priorStd));
        for (std::size_t step = 0; step < advice.pinnedBy.size(); ++step) {
            advice.pinnedBy[step] = core::branchesThatPin(branches, static_cast<int>(step), priorStd, branchesPerStep);
        }
        advice.suggested = core::mostInformativeBranches(branches, priorStd);
        return advice;
    });
}

QString AuxiliaryController::namesOf(const std::vector<int>& branchIds) const
{
    QStringList names;
    for (const int id : branchIds) {
        const core::VesselBranch* branch =
            document_.current().vessels.tree ? document_.current().vessels.tree->find(id) : nullptr;
        names << (branch ? ui::displayName(*branch) : QString::number(id));
    }
    return ui::joinedNames(names);
}

QString AuxiliaryController::previewWords() const
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree) {
        return {};
    }
    double lengthMm = 0.0;
    double chosenMm = 0.0;
    std::vector<int> chosenIds;   // an excluded one is not used, chosen or not
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
    const QString chosen = chosenIds.empty() ? tr("Nothing is chosen: the alternation takes the %1 nodes of the tree.")
                                                   .arg(core::findNodes(*current.vessels.tree).size())
                                             : tr("Chosen: %1 (%2 mm, %3 % of the tree).")
                                                   .arg(namesOf(chosenIds))
                                                   .arg(ui::numberText(chosenMm, 0))
                                                   .arg(ui::numberText(100.0 * chosenMm / std::max(1e-9, lengthMm), 0));
    if (current.options.method == defaultMethod) {
        return tr("%1 AngioPose tries poses found from these alone while its fit is in doubt; a clear fit never asks "
                  "them.")
            .arg(chosen);
    }
    if (!alternates(current.options.method)) {
        return tr("%1 The method chosen now does not alternate and takes all branches.").arg(chosen);
    }
    const auto set = current.options.seed.auxiliary;
    return set == core::AuxiliarySet::Chosen
               ? chosen
               : tr("%1 The option “Auxiliary points” of the method overrules this.").arg(chosen);
}

void AuxiliaryController::show()
{
    if (!dialog_) {
        return;
    }
    ui::AuxiliaryAdvice shown;
    shown.preview = previewWords();
    if (!alternates(document_.current().options.method)) {
        shown.otherMethod = ui::methodWords(alternatingMethod);
    }
    const auto& tree = document_.current().vessels.tree;
    for (const core::VesselBranch& branch : tree ? tree->branches : std::vector<core::VesselBranch>{}) {
        shown.generations = std::max(shown.generations, branch.generation + 1);
        if (!branch.radiusMm.empty()) {
            shown.largestRadiusMm = std::max(shown.largestRadiusMm.value_or(0.0), medianRadiusMm(branch));
        }
    }
    for (std::size_t step = 0; isKnown_ && step < advice_.pinnedBy.size(); ++step) {
        const auto row = static_cast<Eigen::Index>(step);
        shown.steps.push_back({nameOfStep(step), step < 3 ? QStringLiteral("°") : QStringLiteral("mm"),
                               advice_.stdOfAll[row], advice_.stdOfChosen[row], namesOf(advice_.pinnedBy[step])});
    }
    shown.suggestion = isKnown_ ? namesOf(advice_.suggested) : QString();
    dialog_->showAdvice(shown);
}

}   // namespace angiopose::app