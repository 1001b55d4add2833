#pragma once

namespace angiopose::ui {
class MainWindow;
}

namespace angiopose::app {

/// Restores position, column widths and collapsed panels of the window as they were when it was last closed on the same
/// set of screens; on a new set, the most recent layout.
void restoreWindowLayout(ui::MainWindow& window);
void storeWindowLayout(const ui::MainWindow& window);

}   // namespace angiopose::app