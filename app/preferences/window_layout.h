#pragma once

namespace angiopose::ui {
class MainWindow;
}

namespace angiopose::app {

/// Restores the position, column widths and collapsed panels that the window had when it was last closed on the same
/// set of screens; for a new set, restores the most recent layout.
void restoreWindowLayout(ui::MainWindow& window);
void storeWindowLayout(const ui::MainWindow& window);

}   // namespace angiopose::app
