#pragma once

#include "app/registration/registration_controller.h"
#include "ui/main_window.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace angiopose::app {

/// Adapts the window layout to the current step: slices and 3-D view for tracing a scan, image and result for review.
/// Restores the user's changes at the next step of the same kind, including in later sessions.
class StepLayoutController : public QObject {
    Q_OBJECT
public:
    StepLayoutController(const RegistrationController& registration, ui::MainWindow& window, QObject* parent = nullptr);

    void goTo(ui::Step step);   ///< call after the user has selected the step
    void begin();   ///< restores the step layout of the last session; call it after restoring the window layout
    void remember() const;   ///< stores the current layout

private:
    void updateLayout();
    void reset();
    void showFollowingStatus(bool follows);
    std::optional<ui::Activity> makeRetrieval(ui::Step step) const;
    ui::ActivityLayout currentLayout() const;
    ui::ActivityLayout defaultLayout(ui::Activity work) const;
    void show(const ui::ActivityLayout& layout);
    bool canChangeLayout() const;

    const RegistrationController& registration_;
    ui::MainWindow& window_;
    ui::Activity work_ = ui::Activity::Registering;
    std::optional<ui::Activity>
        pendingWork_;   ///< layout to apply as soon as neither a drag nor a registration is in progress
    QTimer applyTimer_;
};

}   // namespace angiopose::app
