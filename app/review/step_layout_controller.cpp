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
using ui::Command;
using ui::Work;

const Setting<QByteArray>& settingOf(Work work)
{
    switch (work) {
        case Work::Tracing:
            return settings::tracingLayout;
        case Work::Reviewing:
            return settings::reviewLayout;
        case Work::Registering:
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
    connect(follows, &QAction::toggled, this, &StepLayoutController::tellFollowing);
    connect(actions[Command::ResetLayout], &QAction::triggered, this, &StepLayoutController::reset);
    connect(&registration, &RegistrationController::runningChanged, this, &StepLayoutController::follow);
    later_.setSingleShot(true);
    later_.setInterval(50ms);
    connect(&later_, &QTimer::timeout, this, &StepLayoutController::follow);
}

void StepLayoutController::tellFollowing(bool follows)
{
    settings::layoutFollowsStep.write(follows);
    if (!follows) {
        wanted_.reset();
    }
}

/// Vessels without a scan get no tracing layout, because there are no slices to show.
std::optional<Work> StepLayoutController::workOf(ui::Step step) const
{
    switch (step) {
        case ui::Step::Vessels:
            return window_.slices().hasScan() ? Work::Tracing : Work::Registering;
        case ui::Step::Review:
            return Work::Reviewing;
        case ui::Step::Export:
            return std::nullopt;   // exporting opens a dialog and needs no layout
        default:
            return Work::Registering;
    }
}

void StepLayoutController::goTo(ui::Step step)
{
    const std::optional<Work> work = workOf(step);
    if (work && window_.actions()[Command::LayoutFollowsStep]->isChecked()) {
        wanted_ = work;
        follow();
    }
}

/// Returns whether the layout may change: not during a drag or a registration.
bool StepLayoutController::isQuiet() const
{
    return !registration_.isRunning() && QGuiApplication::mouseButtons() == Qt::NoButton;
}

void StepLayoutController::follow()
{
    if (!wanted_) {
        return;
    }
    if (!isQuiet()) {
        if (!registration_.isRunning()) {   // called again at the end of a registration
            later_.start();
        }
        return;
    }
    const Work next = *std::exchange(wanted_, std::nullopt);
    if (next == work_) {
        return;
    }
    remember();
    work_ = next;
    show(ui::workLayoutOf(settingOf(next).read()).value_or(asItCame(next)));
}

void StepLayoutController::begin()
{
    const auto stored = ui::workLayoutOf(settingOf(work_).read());
    if (stored && window_.actions()[Command::LayoutFollowsStep]->isChecked()) {
        window_.setColumns(stored->columns);
    }
}

void StepLayoutController::remember() const
{
    if (window_.actions()[Command::LayoutFollowsStep]->isChecked()) {
        settingOf(work_).write(ui::bytesOf(now()));
    }
}

void StepLayoutController::reset()
{
    show(asItCame(work_));
    settingOf(work_).write(ui::bytesOf(now()));
}

ui::WorkLayout StepLayoutController::now() const
{
    return {window_.columns(), window_.actions()[Command::SlicesLarge]->isChecked(), settings::cornerView.read()};
}

ui::WorkLayout StepLayoutController::asItCame(Work work) const
{
    const bool traces = work == Work::Tracing;
    return {ui::columnsFor(work, window_.width()), traces, traces ? 0 : settings::cornerView.read()};
}

/// Applies a layout; the keyboard focus stays on its widget if that remains visible.
void StepLayoutController::show(const ui::WorkLayout& layout)
{
    const QPointer<QWidget> focus = QApplication::focusWidget();
    const ui::WindowActions& actions = window_.actions();
    for (const Command alone :
         {Command::ImageOnly, Command::CornerOnly}) {   // a single view would hide the layout of the step
        if (window_.isOneAlone()) {
            actions[alone]->setChecked(false);
        }
    }
    window_.setColumns(layout.columns);
    if (actions[Command::SlicesLarge]->isEnabled()) {
        actions[Command::SlicesLarge]->setChecked(layout.areSlicesLarge);
    }
    const auto plane = static_cast<std::size_t>(layout.cornerPlane);
    window_.corner().showPlane(plane == 0 ? std::nullopt : std::optional(core::bodyPlanes[plane - 1]));
    if (focus && focus->isVisible()) {
        focus->setFocus(Qt::OtherFocusReason);
    }
}

}   // namespace angiopose::app
