#include "app/views/angle_controller.h"

#include "app/editing/branch_words.h"
#include "app/messages/messages.h"
#include "app/preferences/settings.h"
#include "core/messages/messages.h"
#include "ui/actions/window_actions.h"
#include "ui/words/message_text.h"

namespace angiopose::app {

AngleController::AngleController(CaseDocument& document, BranchController& branches, ui::WindowActions& actions,
                                 QWidget& dialogParent, QObject* parent)
    : QObject(parent),
      document_(document),
      branches_(branches),
      dialogParent_(dialogParent),
      job_({[this](const core::AngleMap& map) { show(map); },
            [this](const core::Error& error) { showNothing(ui::messageText(error.message)); }})
{
    connect(actions[ui::Command::GantryAngles], &QAction::triggered, this, &AngleController::open);
    connect(&document_, &CaseDocument::changed, this, &AngleController::ask);
    connect(&branches_, &BranchController::marksChanged, this, [this] {
        if (dialog_ && !branches_.marks().selected.contains(asked_ ? asked_->branchId : 0)) {
            ask();
        }
    });
}

void AngleController::open()
{
    if (!dialog_) {
        const auto range = [](const Setting<double>& from, const Setting<double>& to) {
            return core::AngleRange{from.read(), to.read()};
        };
        dialog_ = new ui::AngleDialog(
            {range(settings::gantryRao, settings::gantryLao), range(settings::gantryCaudal, settings::gantryCranial)},
            &dialogParent_);
        connect(dialog_, &ui::AngleDialog::picked, this, &AngleController::pick);
        connect(dialog_, &ui::AngleDialog::questionChanged, this, [this] {
            const ui::GantryReach reach = dialog_->reach();
            settings::gantryRao.write(reach.primary.fromDeg);
            settings::gantryLao.write(reach.primary.toDeg);
            settings::gantryCaudal.write(reach.secondary.fromDeg);
            settings::gantryCranial.write(reach.secondary.toDeg);
            ask();
        });
    }
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
    ask();
}

core::Result<AngleController::Question> AngleController::question() const
{
    const core::Case& current = document_.current();
    const auto& selected = branches_.marks().selected;
    const core::VesselBranch* branch =
        current.vessels.tree && selected.size() == 1 ? current.vessels.tree->find(*selected.begin()) : nullptr;
    if (!branch) {
        return core::Error(messages::selectOneBranch());
    }
    const auto camera = core::cameraOf(current.shown());
    const auto poseAt = core::turningGantry(current.shown());
    if (!camera || !poseAt) {
        return camera ? poseAt.error() : camera.error();
    }
    auto sight = core::sightOf(*current.vessels.tree, branch->id,
                               dialog_->isTakeOff() ? core::SightOf::TakeOff : core::SightOf::Branch);
    if (!sight) {
        return sight.error();
    }
    return Question{branch->id, std::move(sight).value(), poseAt.value(), *core::gantryAnglesOf(current.shown()),
                    camera.value()};
}

void AngleController::ask()
{
    if (!dialog_) {
        return;
    }
    auto question = this->question();
    if (!question) {
        showNothing(ui::messageText(question.error().message));
        return;
    }
    asked_ = std::move(question).value();
    const core::VesselTree& tree = *document_.current().vessels.tree;
    dialog_->showBranch(
        tr("C-arm angles for %1").arg(branchWords(tree, {asked_->branchId})()),
        tree.find(asked_->branchId)->radiusMm.empty() ? ui::messageText(core::messages::radiiAssumed()) : QString());
    core::AngleMapOptions options;
    options.primary = dialog_->reach().primary;
    options.secondary = dialog_->reach().secondary;
    job_.start([sight = asked_->sight, poseAt = asked_->poseAt, options](auto& link) -> core::Result<core::AngleMap> {
        return core::mapAngles(sight, poseAt, options, [&link](double done) { return link.tell(done); });
    });
}

void AngleController::show(const core::AngleMap& map)
{
    if (!dialog_) {
        return;
    }
    dialog_->showMap(map, core::AngleSuggestion{asked_->now, asked_->sight.from(asked_->poseAt(asked_->now))});
    pick(map.best.front().angles);
}

void AngleController::pick(const core::GantryAngles& angles)
{
    if (!dialog_ || !asked_) {
        return;
    }
    const core::RigidTransform pose = asked_->poseAt(angles);
    dialog_->showPicked({angles, asked_->sight.from(pose)});
    dialog_->showVessels(document_.current().vessels.tree, asked_->branchId, core::Sight{asked_->camera, pose});
}

void AngleController::showNothing(const QString& why)
{
    asked_.reset();
    job_.drop();
    if (dialog_) {
        dialog_->showBranch(tr("No branch"), why);
        dialog_->showMap({}, {});
        dialog_->showVessels(nullptr, 0, {});
    }
}

}   // namespace angiopose::app
