#pragma once

#include <QWidget>

namespace angiopose::ui {

/// Moves and shrinks a window to fit into the `available` area, since its saved geometry may come from a larger screen
/// or a smaller scale factor. At 200 %, a screen has half as many points as at 100 %.
void fitToScreen(const QRect& available, QWidget& window);

/// Resizes the window to `requestedSize`, but at most to the screen size minus the window frame.
void resizeWithinScreen(QWidget& window, const QSize& requestedSize);

}   // namespace angiopose::ui
