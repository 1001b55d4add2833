#pragma once

#include "app/case_controller.h"
#include "ui/main_window.h"

namespace angiopose::app {

/// The window and all behind it.
class WindowHost {
public:
    WindowHost();

    ui::MainWindow& window() { return window_; }
    CaseController& controller() { return controller_; }

private:
    ui::MainWindow window_;
    CaseController controller_;
};

}   // namespace angiopose::app