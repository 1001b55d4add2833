#pragma once

#include "app/registration/registration_controller.h"
#include "ui/main_window.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace angiopose::app {

/// Adapts the window layout to the step: slices and 3-D view while a scan is traced, image and result during review.
/// Layout changes by the user are restored in the next step of the same kind, also in later sessions.
class StepLayoutController : public QObject {
    Q_OBJECT
public:
    StepLayoutController(const RegistrationController& registration, ui::MainWindow& window, QObject* parent = nullptr);

    void goTo(ui::Step step);   ///< after the user selected the step
    void begin();   ///< continues with the last session's step layout; call it after the window layout is restored
    void remember() const;   ///< stores the current layout

private:
    void follow();
    void reset();
    void tellFollowing(bool follows);
    std::optional<ui::Work> workOf(ui::Step step) const;
    ui::WorkLayout now() const;
    ui::WorkLayout asItCame(ui::Work work) const;
    void show(const ui::WorkLayout& layout);
    bool isQuiet() const;

    const RegistrationController& registration_;
    ui::MainWindow& window_;
    ui::Work work_ = ui::Work::Registering;
    std::optional<ui::Work> wanted_;   ///< applied once no drag and no registration is in progress
    QTimer later_;
};

}   // namespace angiopose::app
