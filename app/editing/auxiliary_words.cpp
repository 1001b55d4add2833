#include "app/editing/auxiliary_words.h"

#include "app/editing/auxiliary_controller.h"
#include "core/registration/options/option_fields.h"
#include "core/support/quantile.h"
#include "ui/panels/result_sentences.h"
#include "ui/words/language.h"
#include "ui/words/number.h"
#include "ui/words/terms.h"

#include <algorithm>
#include <array>

namespace angiopose::app {
namespace {

/// Returns the name of a pose component as in the pose panel; order as in core::PoseUncertainty.
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

const std::string defaultMethod = "angiopose";

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
    return ui::joinedNames(names);
}

/// Describes which branches the alternating method would currently use.
QString previewWords(const core::Case& current)
{
    if (!current.vessels.tree) {
        return {};
    }
    double lengthMm = 0.0;
    double chosenMm = 0.0;
    std::vector<int> chosenIds;   // excluded branches are left out, since they are never used
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
            ? AuxiliaryController::tr("No auxiliary branches selected: the alternation uses the %1 nodes of the tree.")
                  .arg(core::findNodes(*current.vessels.tree).size())
            : AuxiliaryController::tr("Auxiliary: %1 (%2 mm, %3 % of the tree).")
                  .arg(namesOf(current.vessels.tree, chosenIds))
                  .arg(ui::numberText(chosenMm, 0))
                  .arg(ui::numberText(100.0 * chosenMm / std::max(1e-9, lengthMm), 0));
    if (current.options.method == defaultMethod) {
        return chosenIds.empty()
                   ? AuxiliaryController::tr(
                         "No auxiliary branches selected: AngioPose weights all branches equally. Auxiliary branches "
                         "determine the pose components they constrain; the other branches constrain the rest.")
                   : AuxiliaryController::tr(
                         "%1 In AngioPose, they determine the pose components they constrain; the other branches "
                         "constrain the rest. The result also reports the fit of all branches. If confidence is low, "
                         "AngioPose also tries poses found from these branches alone.")
                         .arg(chosen);
    }
    if (!alternates(current.options.method)) {
        return AuxiliaryController::tr("%1 The current method does not alternate and uses all branches.").arg(chosen);
    }
    const auto set = current.options.seed.auxiliary;
    return set == core::AuxiliarySet::Chosen
               ? chosen
               : AuxiliaryController::tr("%1 The method option “Auxiliary points” takes precedence.").arg(chosen);
}

}   // namespace

const std::string alternatingMethod = "dynaweight";

double medianRadiusMm(const core::VesselBranch& branch)
{
    return branch.radiusMm.empty() ? 0.0 : core::quantile(branch.radiusMm, 0.5);
}

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
            shown.largestRadiusMm = std::max(shown.largestRadiusMm.value_or(0.0), medianRadiusMm(branch));
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

}   // namespace angiopose::app
