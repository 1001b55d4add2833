#pragma once

#include "app/registration/registration_controller.h"
#include "ui/main_window.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace angiopose::app {

/// The window's layout goes with the step: slices and 3-D view while a scan is traced, image and result while a result
/// is looked at. What the user changed by hand is there again in the next step of its kind, in this session and later.
class StepLayoutController : public QObject {
    Q_OBJECT
public:
    StepLayoutController(const RegistrationController& registration, ui::MainWindow& window, QObject* parent = nullptr);

    void goTo(ui::Step step);   ///< the user went there
    void begin();   ///< takes up where the last session left; the stored layout of the window is there already
    void remember() const;   ///< the layout as it is, for the next time

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
    std::optional<ui::Work> wanted_;   ///< once nobody drags and nothing runs
    QTimer later_;
};

}   // namespace angiopose::app
