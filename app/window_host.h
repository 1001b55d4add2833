#pragma once

#include "app/case_controller.h"
#include "ui/main_window.h"
#include "ui/theme/without_style_sheet.h"

#include <optional>

namespace angiopose::app {

/// Owns the main window and its controllers.
class WindowHost {
public:
    WindowHost();

    ui::MainWindow& window() { return window_; }
    CaseController& controller() { return controller_; }

private:
    std::optional<ui::WithoutStyleSheet> styleSheetSuspension_{
        std::in_place};   ///< suspends the style sheet during the construction of the window
    ui::MainWindow window_;
    CaseController controller_;
};

}   // namespace angiopose::app
