#pragma once

namespace angiopose::ui {
class MainWindow;
}

namespace angiopose::app {

/// Place, widths and folded parts of the window as they were when it was last closed on a set of screens like this; on
/// a new set as they were last.
void restoreWindowLayout(ui::MainWindow& window);
void storeWindowLayout(const ui::MainWindow& window);

}   // namespace angiopose::app