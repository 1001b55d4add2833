#include "app/review/drr_controller.h"

#include "core/case/registration_input.h"
#include "ui/panels/bottom_strip.h"
#include "ui/views/angiogram_view.h"
#include "ui/words/message_text.h"

namespace angiopose::app {
DrrController::DrrController(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts)
{
    connect(&parts_.overlayStyle, &OverlayStyleController::drrRequested, this, &DrrController::setEnabled);
    connect(&parts_.document, &CaseDocument::changed, this, &DrrController::updateFromDocument);
    connect(&parts_.target, &TargetProvider::changed, this, &DrrController::updateFromDocument);
    connect(&parts_.sync, &ViewSync::poseShown, this, [this](const core::RigidTransform& cameraFromPatient) {
        if (isEnabled_ && isReady_) {
            job_.request(cameraFromPatient);
        }
    });
    connect(&job_, &DrrJob::rendered, this, [this](const core::ImageF& picture) {
        if (isEnabled_) {
            show(picture);
        }
    });
    connect(&job_, &DrrJob::failed, this,
            [this](const core::Message& reason) { parts_.strip.showStatus(ui::messageText(reason)); });
}

void DrrController::setEnabled(bool enabled)
{
    isEnabled_ = enabled;
    if (enabled) {
        updateFromDocument();
        if (isReady_) {
            job_.request(parts_.document.current().shown().cameraFromPatient);
        }
    } else {
        clear();
    }
}

void DrrController::clear()
{
    job_.clear();
    isReady_ = false;
    tree_.reset();
    volume_.reset();
    show({});
}

void DrrController::updateFromDocument()
{
    const core::Case& current = parts_.document.current();
    const auto camera = core::cameraOf(current.shown());
    const std::optional<core::ProjectionCamera> known = camera ? std::optional(camera.value()) : std::nullopt;
    const bool isSame = isReady_ && current.vessels.tree == tree_ && current.vessels.scan == volume_ &&
                        known == camera_ && current.vessels.excludedBranchIds == excluded_;
    if (isReady_ && !(current.vessels.tree && current.shown().angiogram)) {
        clear();
    }
    if (!isEnabled_ || isSame || !parts_.target.current()) {
        return;
    }
    auto input = core::makeRegistrationInput(current, *parts_.target.current());
    if (!input) {
        clear();
        return;
    }
    isReady_ = true;
    tree_ = current.vessels.tree;
    volume_ = current.vessels.scan;
    camera_ = known;
    excluded_ = current.vessels.excludedBranchIds;
    job_.setInput(std::move(input).value(), current.options);
    job_.request(current.shown().cameraFromPatient);
}

void DrrController::show(const core::ImageF& picture)
{
    parts_.view.scene().setDrr(picture);
    parts_.view.redraw();
}

}   // namespace angiopose::app
