#include "app/review/step_layout_controller.h"

#include "app/preferences/settings.h"
#include "ui/places/folding_column.h"
#include "ui/places/view_frame.h"
#include "ui/slices/corner_views.h"

#include <QApplication>
#include <QPointer>

#include <chrono>

namespace angiopose::app {
namespace {

using namespace std::chrono_literals;
using ui::Activity;
using ui::Command;

const Setting<QByteArray>& settingOf(Activity work)
{
    switch (work) {
        case Activity::Tracing:
            return settings::tracingLayout;
        case Activity::Reviewing:
            return settings::reviewLayout;
        case Activity::Registering:
            break;
    }
    return settings::registrationLayout;
}

}   // namespace

StepLayoutController::StepLayoutController(const RegistrationController& registration, ui::MainWindow& window,
                                           QObject* parent)
    : QObject(parent), registration_(registration), window_(window)
{
    const ui::WindowActions& actions = window.actions();
    QAction* follows = actions[Command::LayoutFollowsStep];
    follows->setChecked(settings::layoutFollowsStep.read());
    connect(follows, &QAction::toggled, this, &StepLayoutController::showFollowingStatus);
    connect(actions[Command::ResetLayout], &QAction::triggered, this, &StepLayoutController::reset);
    connect(&registration, &RegistrationController::runningChanged, this, &StepLayoutController::updateLayout);
    applyTimer_.setSingleShot(true);
    applyTimer_.setInterval(50ms);
    connect(&applyTimer_, &QTimer::timeout, this, &StepLayoutController::updateLayout);
}

void StepLayoutController::showFollowingStatus(bool follows)
{
    settings::layoutFollowsStep.write(follows);
    if (!follows) {
        pendingWork_.reset();
    }
}

/// There is no tracing layout for vessels without a scan, because there are no slices to show.
std::optional<Activity> StepLayoutController::makeRetrieval(ui::Step step) const
{
    switch (step) {
        case ui::Step::Vessels:
            return window_.slices().hasScan() ? Activity::Tracing : Activity::Registering;
        case ui::Step::Review:
            return Activity::Reviewing;
        case ui::Step::Export:
            return std::nullopt;   // exporting opens a dialog and needs no layout
        default:
            return Activity::Registering;
    }
}

void StepLayoutController::goTo(ui::Step step)
{
    const std::optional<Activity> work = makeRetrieval(step);
    if (work && window_.actions()[Command::LayoutFollowsStep]->isChecked()) {
        pendingWork_ = work;
        updateLayout();
    }
}

/// Returns whether the layout may change: not during a drag or a registration.
bool StepLayoutController::canChangeLayout() const
{
    return !registration_.isRunning() && QGuiApplication::mouseButtons() == Qt::NoButton;
}

void StepLayoutController::updateLayout()
{
    if (!pendingWork_) {
        return;
    }
    if (!canChangeLayout()) {
        if (!registration_.isRunning()) {   // called again at the end of registration
            applyTimer_.start();
        }
        return;
    }
    const Activity next = *std::exchange(pendingWork_, std::nullopt);
    if (next == work_) {
        return;
    }
    remember();
    work_ = next;
    show(ui::activityLayoutFromBytes(settingOf(next).read()).value_or(defaultLayout(next)));
}

void StepLayoutController::begin()
{
    const auto stored = ui::activityLayoutFromBytes(settingOf(work_).read());
    if (stored && window_.actions()[Command::LayoutFollowsStep]->isChecked()) {
        window_.setColumns(stored->columns);
    }
}

void StepLayoutController::remember() const
{
    if (window_.actions()[Command::LayoutFollowsStep]->isChecked()) {
        settingOf(work_).write(ui::toBytes(currentLayout()));
    }
}

void StepLayoutController::reset()
{
    show(defaultLayout(work_));
    settingOf(work_).write(ui::toBytes(currentLayout()));
}

ui::ActivityLayout StepLayoutController::currentLayout() const
{
    return {window_.columns(), window_.actions()[Command::SlicesLarge]->isChecked(), settings::cornerView.read()};
}

ui::ActivityLayout StepLayoutController::defaultLayout(Activity work) const
{
    const bool traces = work == Activity::Tracing;
    return {ui::defaultColumns(work, window_.width()), traces, traces ? 0 : settings::cornerView.read()};
}

/// Applies a layout; the keyboard focus stays on its widget if the widget stays visible.
void StepLayoutController::show(const ui::ActivityLayout& layout)
{
    const QPointer<QWidget> focus = QApplication::focusWidget();
    const ui::WindowActions& actions = window_.actions();
    for (const Command alone :
         {Command::ImageOnly, Command::CornerOnly}) {   // a single view would hide the layout of the step
        if (window_.isViewMaximized()) {
            actions[alone]->setChecked(false);
        }
    }
    window_.setColumns(layout.columns);
    if (actions[Command::SlicesLarge]->isEnabled()) {
        actions[Command::SlicesLarge]->setChecked(layout.areSlicesEnlarged);
    }
    const auto plane = static_cast<std::size_t>(layout.cornerPlane);
    window_.corner().showPlane(plane == 0 ? std::nullopt : std::optional(core::bodyPlanes[plane - 1]));
    if (focus && focus->isVisible()) {
        focus->setFocus(Qt::OtherFocusReason);
    }
}

}   // namespace angiopose::app
