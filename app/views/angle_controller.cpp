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
            [this](const core::Error& error) { showReason(ui::messageText(error.message)); }})
{
    connect(actions[ui::Command::GantryAngles], &QAction::triggered, this, &AngleController::open);
    connect(&document_, &CaseDocument::changed, this, &AngleController::requestMap);
    connect(&branches_, &BranchController::marksChanged, this, [this] {
        if (dialog_ && !branches_.marks().selected.contains(requested_ ? requested_->branchId : 0)) {
            requestMap();
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
        connect(dialog_, &ui::AngleDialog::criteriaChanged, this, [this] {
            const ui::GantryLimits limits = dialog_->limits();
            settings::gantryRao.write(limits.primary.fromDeg);
            settings::gantryLao.write(limits.primary.toDeg);
            settings::gantryCaudal.write(limits.secondary.fromDeg);
            settings::gantryCranial.write(limits.secondary.toDeg);
            requestMap();
        });
    }
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
    requestMap();
}

core::Result<AngleController::MapRequest> AngleController::mapRequest() const
{
    const core::Case& current = document_.current();
    const auto& selected = branches_.marks().selected;
    const core::VesselBranch* branch =
        current.vessels.tree && selected.size() == 1 ? current.vessels.tree->find(*selected.begin()) : nullptr;
    if (!branch) {
        return core::Error(messages::selectOneBranch());
    }
    const auto camera = core::cameraOf(current.shown());
    const auto poseAt = core::poseForGantryAngles(current.shown());
    if (!camera || !poseAt) {
        return camera ? poseAt.error() : camera.error();
    }
    auto sight =
        core::makeViewEvaluator(*current.vessels.tree, branch->id,
                                dialog_->isTakeOff() ? core::EvaluatedPart::Takeoff : core::EvaluatedPart::Branch);
    if (!sight) {
        return sight.error();
    }
    return MapRequest{branch->id, std::move(sight).value(), poseAt.value(), *core::gantryAnglesOf(current.shown()),
                      camera.value()};
}

void AngleController::requestMap()
{
    if (!dialog_) {
        return;
    }
    auto mapRequest = this->mapRequest();
    if (!mapRequest) {
        showReason(ui::messageText(mapRequest.error().message));
        return;
    }
    requested_ = std::move(mapRequest).value();
    const core::VesselTree& tree = *document_.current().vessels.tree;
    dialog_->showBranch(tr("C-arm angles for %1").arg(branchNames(tree, {requested_->branchId})()),
                        tree.find(requested_->branchId)->radiusMm.empty()
                            ? ui::messageText(core::messages::radiiAssumed())
                            : QString());
    core::AngleMapOptions options;
    options.primary = dialog_->limits().primary;
    options.secondary = dialog_->limits().secondary;
    job_.start(
        [sight = requested_->sight, poseAt = requested_->poseAt, options](auto& link) -> core::Result<core::AngleMap> {
            return core::computeAngleMap(sight, poseAt, options, [&link](double done) { return link.tell(done); });
        });
}

void AngleController::show(const core::AngleMap& map)
{
    if (!dialog_) {
        return;
    }
    dialog_->showMap(
        map, core::AngleSuggestion{requested_->now, requested_->sight.from(requested_->poseAt(requested_->now))});
    pick(map.best.front().angles);
}

void AngleController::pick(const core::GantryAngles& angles)
{
    if (!dialog_ || !requested_) {
        return;
    }
    const core::RigidTransform pose = requested_->poseAt(angles);
    dialog_->showPicked({angles, requested_->sight.from(pose)});
    dialog_->showVessels(document_.current().vessels.tree, requested_->branchId,
                         core::PosedCamera{requested_->camera, pose});
}

void AngleController::showReason(const QString& reason)
{
    requested_.reset();
    job_.drop();
    if (dialog_) {
        dialog_->showBranch(tr("No branch"), reason);
        dialog_->showMap({}, {});
        dialog_->showVessels(nullptr, 0, {});
    }
}

}   // namespace angiopose::app
